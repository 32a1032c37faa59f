// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
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
        throw base::InputError("optimizer '" + std::string(method.name) + "' needs what problem '" +
                               problem.name() +
                               "' does not offer: " + std::string(evaluation_name(method.needs)));
    }
    OptimizationReport report = minimize(problem, *method.make(options), budget);
    report.optimizer = method.name;
    return report;
}

OptimizationReport minimize(const Problem& problem, const Optimizer& optimizer, const Budget& budget) {
    Evaluator evaluator(problem, budget);
    base::Progress* progress = budget.control.progress;
    if (progress != nullptr) progress->start("minimize", budget.cost);
    RunOutcome outcome = optimizer.run(evaluator);
    if (progress != nullptr) progress->finish();
    return report_of(evaluator, std::move(outcome));
}

}  // namespace fretwork::optimization
