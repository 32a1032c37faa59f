// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/optimization/ceres_multistart.hpp>
#include <fretwork/optimization/gauss_newton_multistart.hpp>
#include <fretwork/optimization/optimizer_catalogue.hpp>
#include <fretwork/optimization/random_search.hpp>
#include <fretwork/optimization/simulated_annealing.hpp>

#include <algorithm>
#include <array>

namespace fretwork::optimization {
namespace {

constexpr std::array kRows = {
    OptimizerRow{
        "ceres-multistart",
        "Ceres Levenberg-Marquardt with bounds: kinks smoothed by continuation, curvature of norms kept, "
        "screened starts",
        OptimizerClass::Global, Evaluation::Curvature,
        [](const OptimizerOptions& options) { return make_ceres_multistart({.common = options}); }},
    OptimizerRow{"ceres-residuals",
                 "Ceres Levenberg-Marquardt with bounds on the bare residuals from low-discrepancy starts",
                 OptimizerClass::Global, Evaluation::Residuals,
                 [](const OptimizerOptions& options) { return make_ceres_residuals({.common = options}); }},
    OptimizerRow{
        "gauss-newton-multistart",
        "As ceres-multistart with a projected trust-region step of our own, exact at the bounds",
        OptimizerClass::Global, Evaluation::Curvature,
        [](const OptimizerOptions& options) { return make_gauss_newton_multistart({.common = options}); }},
    OptimizerRow{
        "simulated-annealing",
        "Simulated annealing with ensmallen's algorithm and defaults in the unit box, reflected at bounds",
        OptimizerClass::Random, Evaluation::Value,
        [](const OptimizerOptions& options) { return make_simulated_annealing({.common = options}); }},
    OptimizerRow{"random-search", "Independent uniform points until the budget is spent: the floor",
                 OptimizerClass::Random, Evaluation::Value,
                 [](const OptimizerOptions& options) { return make_random_search(options); }},
};

OptimizationReport report_of(const Evaluator& evaluator, RunOutcome outcome) {
    OptimizationReport report;
    report.termination = evaluator.trace().empty() ? Termination::Invalid : outcome.termination;
    report.point = evaluator.best_point();
    report.value = evaluator.best_value();
    report.final_point = std::move(outcome.final_point);
    report.cost = evaluator.cost();
    report.evaluations = evaluator.evaluations();
    report.failures = evaluator.failures();
    report.points_outside = evaluator.points_outside();
    report.trace = evaluator.trace();
    return report;
}

}  // namespace

std::span<const OptimizerRow> optimizer_catalogue() {
    return kRows;
}

const OptimizerRow& find_optimizer(std::string_view name) {
    const auto row = std::ranges::find(kRows, name, &OptimizerRow::name);
    if (row != kRows.end()) return *row;
    std::vector<std::string> names;
    for (const OptimizerRow& candidate : kRows) names.emplace_back(candidate.name);
    throw base::InputError(base::unknown_name_message("optimizer", name, names));
}

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
    RunOutcome outcome = optimizer.run(evaluator);
    return report_of(evaluator, std::move(outcome));
}

}  // namespace fretwork::optimization
