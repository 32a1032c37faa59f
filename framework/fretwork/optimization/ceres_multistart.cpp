// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/optimization/ceres_multistart.hpp>
#include <fretwork/optimization/detail/ceres_descent.hpp>
#include <fretwork/optimization/detail/starts.hpp>

namespace fretwork::optimization {
namespace {

class CeresMultistart final : public Optimizer {
  public:
    explicit CeresMultistart(const CeresMultistartOptions& options) : options_(options) {}

    RunOutcome run(Evaluator& evaluator) const override {
        RunOutcome outcome{Ending::BudgetSpent, {}};
        const int samples = options_.common.starts * options_.continuation.samples_per_start;
        for (const Eigen::VectorXd& start : detail::choose_starts(evaluator, options_.common, samples)) {
            outcome.final_point = start;
            outcome.ending = detail::descend_by_ceres(evaluator, options_.continuation, outcome.final_point);
            if (outcome.ending == Ending::BudgetSpent) break;
        }
        return outcome;
    }

  private:
    CeresMultistartOptions options_;
};

}  // namespace

void CeresMultistartOptions::validate() const {
    common.validate();
    continuation.validate();
}

std::unique_ptr<Optimizer> make_ceres_multistart(const CeresMultistartOptions& options) {
    options.validate();
    return std::make_unique<CeresMultistart>(options);
}

}  // namespace fretwork::optimization
