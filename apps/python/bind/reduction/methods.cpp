// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/bind.hpp"
#include "reduction/methods.hpp"
#include "reduction/problems.hpp"

#include <fretwork/base/error.hpp>

namespace fretwork::python {
namespace {

using namespace optimization;

/// How a run ended, from what its function returns: a RunOutcome, the point where it stood, or None.
RunOutcome outcome_of(const py::object& returned, const Evaluator& evaluator) {
    RunOutcome outcome;
    if (py::isinstance<RunOutcome>(returned))
        outcome = returned.cast<RunOutcome>();
    else if (!returned.is_none())
        outcome.final_point = returned.cast<Eigen::VectorXd>();
    if (outcome.final_point.size() == 0) outcome.final_point = evaluator.best_point();
    if (outcome.final_point.size() != 0) check_dimension(evaluator.problem(), outcome.final_point);
    return outcome;
}

class PythonMethod final : public Optimizer {
  public:
    PythonMethod(RunFunction run, const OptimizerOptions& options) : run_(std::move(run)), options_(options) {
        options_.validate();
    }
    RunOutcome run(Evaluator& evaluator) const override {
        const py::gil_scoped_acquire acquired;
        const auto running = std::make_shared<Evaluator*>(&evaluator);
        const struct Ending {
            Evaluator** running;
            ~Ending() { *running = nullptr; }
        } ending{running.get()};
        return outcome_of(run_(RunningEvaluator(running), options_), evaluator);
    }

  private:
    RunFunction run_;
    OptimizerOptions options_;
};

}  // namespace

Evaluator& RunningEvaluator::get() const {
    if (*evaluator_ == nullptr) throw base::Error("the run that this evaluator was made for is over");
    return **evaluator_;
}

Evaluator& RunningEvaluator::at(const Eigen::VectorXd& point) const {
    check_dimension(get().problem(), point);
    return get();
}

OptimizerRow make_method(std::string name, RunFunction run, std::string summary, OptimizerClass kind,
                         Evaluation needs) {
    return {std::move(name), std::move(summary), kind, needs,
            [run = std::move(run)](const OptimizerOptions& options) -> std::unique_ptr<Optimizer> {
                return std::make_unique<PythonMethod>(run, options);
            }};
}

std::vector<OptimizerRow> rows_and_all(const std::vector<OptimizerRow>& own) {
    std::vector<OptimizerRow> rows = own;
    rows.insert(rows.end(), optimizer_catalogue().begin(), optimizer_catalogue().end());
    return rows;
}

std::vector<OptimizerRow> taken_optimizers(py::dict& named) {
    const py::object given = taken(named, "optimizers");
    return rows_and_all(given.is_none() ? std::vector<OptimizerRow>{}
                                        : given.cast<std::vector<OptimizerRow>>());
}

}  // namespace fretwork::python
