// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/casters.hpp"

#include <fretwork/optimization/optimizer_catalogue.hpp>

#include <functional>
#include <memory>
#include <vector>

namespace fretwork::python {

/// An evaluator for the time of a run. Its functions throw Error after the run.
class RunningEvaluator {
  public:
    explicit RunningEvaluator(std::shared_ptr<optimization::Evaluator*> evaluator)
        : evaluator_(std::move(evaluator)) {}
    /// Throws Error once the run is over.
    [[nodiscard]] optimization::Evaluator& get() const;
    /// The same, and throws InputError unless the point has as many numbers as the problem has variables.
    [[nodiscard]] optimization::Evaluator& at(const Eigen::VectorXd& point) const;

  private:
    std::shared_ptr<optimization::Evaluator*> evaluator_;  ///< null once the run is over
};

using RunFunction = std::function<py::object(const RunningEvaluator&, const optimization::OptimizerOptions&)>;

/// A method that is a Python function.
optimization::OptimizerRow make_method(std::string name, RunFunction run, std::string summary,
                                       optimization::OptimizerClass kind, optimization::Evaluation needs);

/// The own methods, followed by those of optimization::optimizer_catalogue().
std::vector<optimization::OptimizerRow> rows_and_all(const std::vector<optimization::OptimizerRow>& own);

/// Takes the methods of a call, `optimizers`, out of its keywords: they are added to those of the catalogue.
std::vector<optimization::OptimizerRow> taken_optimizers(py::dict& named);

}  // namespace fretwork::python
