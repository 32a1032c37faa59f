// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/task.hpp>
#include <fretwork/optimization/minimize.hpp>

#include <utility>

namespace fretwork::optimization {
namespace {

OptimizationReport report_of(const Evaluator& evaluator, RunOutcome outcome) {
    OptimizationReport report;
    report.ending = evaluator.trace().empty() ? Ending::Invalid : outcome.ending;
    report.dead_starts = outcome.dead_starts;
    report.point = evaluator.best_point();
    report.value = evaluator.best_value();
    report.final_point = std::move(outcome.final_point);
    report.cost = evaluator.cost();
    report.evaluations = evaluator.evaluations();
    report.derivative_evaluations = evaluator.derivative_evaluations();
    report.failures = evaluator.failures();
    report.points_outside = evaluator.points_outside();
    report.trace = evaluator.trace();
    return report;
}

}  // namespace

OptimizationReport minimize(const Problem& problem, const OptimizerRow& method,
                            const OptimizerOptions& options, const Budget& budget) {
    options.validate();
    if (!problem.offers(method.needs)) {
        throw base::InputError("optimizer '" + method.name + "' needs the evaluation '" +
                               std::string(evaluation_name(method.needs)) + "', which problem '" +
                               problem.name() + "' does not offer");
    }
    OptimizationReport report = minimize(problem, *method.make(options), budget);
    report.optimizer = method.name;
    return report;
}

OptimizationReport minimize(const Problem& problem, const Optimizer& optimizer, const Budget& budget) {
    Evaluator evaluator(problem, budget);
    const base::Task task(budget.control, "minimize", budget.cost);
    return report_of(evaluator, optimizer.run(evaluator));
}

}  // namespace fretwork::optimization
