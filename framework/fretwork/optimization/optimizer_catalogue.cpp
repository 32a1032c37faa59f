// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/optimization/annealing_then_ceres.hpp>
#include <fretwork/optimization/bobyqa.hpp>
#include <fretwork/optimization/ceres_multistart.hpp>
#include <fretwork/optimization/ceres_residuals.hpp>
#include <fretwork/optimization/cma_es.hpp>
#include <fretwork/optimization/corana_annealing.hpp>
#include <fretwork/optimization/crs2.hpp>
#include <fretwork/optimization/differential_evolution.hpp>
#include <fretwork/optimization/direct_l.hpp>
#include <fretwork/optimization/gauss_newton_multistart.hpp>
#include <fretwork/optimization/mlsl.hpp>
#include <fretwork/optimization/optimizer_catalogue.hpp>
#include <fretwork/optimization/random_search.hpp>
#include <fretwork/optimization/simulated_annealing.hpp>
#include <fretwork/optimization/slsqp.hpp>
#include <fretwork/optimization/subplex.hpp>

#include <algorithm>
#include <array>

namespace fretwork::optimization {
namespace {

using Made = std::unique_ptr<Optimizer>;
using Options = const OptimizerOptions&;

/// Annealing that differs from the published defaults.
Made annealing(SimulatedAnnealingOptions options, Options common) {
    options.common = common;
    return make_simulated_annealing(options);
}

Made ceres_residuals(CeresResidualsOptions options, Options common) {
    options.common = common;
    return make_ceres_residuals(options);
}

/// Of the continuation of ceres-multistart, so that the two differ in what Ceres sees, not in the stages.
std::vector<double> stages() {
    return ContinuationOptions{}.smoothing;
}

constexpr std::array kRows = {
    OptimizerRow{
        "ceres-multistart",
        "Ceres Levenberg-Marquardt with bounds: kinks smoothed by continuation, curvature of norms kept, "
        "screened starts",
        OptimizerClass::Local, Evaluation::Curvature,
        [](Options o) { return make_ceres_multistart({.common = o}); }},
    OptimizerRow{"gauss-newton-multistart",
                 "As ceres-multistart with a projected trust-region step of our own, exact at the bounds",
                 OptimizerClass::Local, Evaluation::Curvature,
                 [](Options o) { return make_gauss_newton_multistart({.common = o}); }},
    OptimizerRow{"ceres-residuals",
                 "Ceres Levenberg-Marquardt with bounds on the bare residuals from low-discrepancy starts",
                 OptimizerClass::Local, Evaluation::Residuals,
                 [](Options o) { return ceres_residuals({}, o); }},
    OptimizerRow{"ceres-dogleg", "As ceres-residuals with Powell's dogleg", OptimizerClass::Local,
                 Evaluation::Residuals,
                 [](Options o) { return ceres_residuals({.step = CeresStep::Dogleg}, o); }},
    OptimizerRow{"ceres-subspace-dogleg", "As ceres-residuals with the dogleg in a plane of two directions",
                 OptimizerClass::Local, Evaluation::Residuals,
                 [](Options o) { return ceres_residuals({.step = CeresStep::SubspaceDogleg}, o); }},
    OptimizerRow{"ceres-sine", "As ceres-residuals with bounds kept by x = middle + half width * sin(u)",
                 OptimizerClass::Local, Evaluation::Residuals,
                 [](Options o) { return ceres_residuals({.bounds = CeresBounds::Sine}, o); }},
    OptimizerRow{"ceres-smoothed", "As ceres-residuals with kinks smoothed by continuation",
                 OptimizerClass::Local, Evaluation::Residuals,
                 [](Options o) { return ceres_residuals({.smoothing = stages()}, o); }},
    OptimizerRow{
        "ceres-smoothed-dogleg", "As ceres-smoothed with Powell's dogleg", OptimizerClass::Local,
        Evaluation::Residuals,
        [](Options o) { return ceres_residuals({.step = CeresStep::Dogleg, .smoothing = stages()}, o); }},
    OptimizerRow{"ceres-smoothed-subspace-dogleg", "As ceres-smoothed with the step of ceres-subspace-dogleg",
                 OptimizerClass::Local, Evaluation::Residuals,
                 [](Options o) {
                     return ceres_residuals({.step = CeresStep::SubspaceDogleg, .smoothing = stages()}, o);
                 }},
    OptimizerRow{
        "ceres-smoothed-sine", "As ceres-smoothed with the bounds of ceres-sine", OptimizerClass::Local,
        Evaluation::Residuals,
        [](Options o) { return ceres_residuals({.bounds = CeresBounds::Sine, .smoothing = stages()}, o); }},
    OptimizerRow{"bobyqa", "BOBYQA of NLopt on values from low-discrepancy starts", OptimizerClass::Local,
                 Evaluation::Value, [](Options o) { return make_bobyqa({.common = o}); }},
    OptimizerRow{"subplex", "Subplex of NLopt on values from low-discrepancy starts", OptimizerClass::Local,
                 Evaluation::Value, [](Options o) { return make_subplex({.common = o}); }},
    OptimizerRow{"slsqp", "SLSQP of NLopt on gradients from low-discrepancy starts", OptimizerClass::Local,
                 Evaluation::Gradient, [](Options o) { return make_slsqp({.common = o}); }},
    OptimizerRow{"direct-l", "DIRECT-L of NLopt: divides the box", OptimizerClass::Global, Evaluation::Value,
                 [](Options o) { return make_direct_l({.common = o}); }},
    OptimizerRow{"mlsl", "Multi-level single linkage of NLopt: Sobol points and SLSQP",
                 OptimizerClass::Global, Evaluation::Gradient,
                 [](Options o) { return make_mlsl({.common = o}); }},
    OptimizerRow{"crs2", "Controlled random search with local mutation of NLopt", OptimizerClass::Random,
                 Evaluation::Value, [](Options o) { return make_crs2({.common = o}); }},
    OptimizerRow{"cma-es", "CMA-ES of pagmo; each restart doubles the population", OptimizerClass::Random,
                 Evaluation::Value, [](Options o) { return make_cma_es({.common = o}); }},
    OptimizerRow{"differential-evolution", "Differential evolution rand/1/exp of pagmo",
                 OptimizerClass::Random, Evaluation::Value,
                 [](Options o) { return make_differential_evolution({.common = o}); }},
    OptimizerRow{
        "simulated-annealing",
        "Simulated annealing with ensmallen's algorithm and defaults in the unit box, reflected at bounds",
        OptimizerClass::Random, Evaluation::Value, [](Options o) { return annealing({}, o); }},
    OptimizerRow{"annealing-clamp", "As simulated-annealing; a move beyond a bound ends on it",
                 OptimizerClass::Random, Evaluation::Value,
                 [](Options o) { return annealing({.bounds = AnnealingBounds::Clamp}, o); }},
    OptimizerRow{"annealing-reject", "As simulated-annealing; a move beyond a bound is rejected",
                 OptimizerClass::Random, Evaluation::Value,
                 [](Options o) { return annealing({.bounds = AnnealingBounds::Reject}, o); }},
    OptimizerRow{"annealing-raw", "As simulated-annealing in quantities instead of their logarithms",
                 OptimizerClass::Random, Evaluation::Value,
                 [](Options o) { return annealing({.variables = AnnealingVariables::Quantities}, o); }},
    OptimizerRow{"annealing-cool", "As simulated-annealing from a temperature of 10 instead of 10,000",
                 OptimizerClass::Random, Evaluation::Value,
                 [](Options o) { return annealing({.initial_temperature = 10.0}, o); }},
    OptimizerRow{"corana-annealing", "Simulated annealing with adaptive neighbourhoods (Corana) of pagmo",
                 OptimizerClass::Random, Evaluation::Value,
                 [](Options o) { return make_corana_annealing({.common = o}); }},
    OptimizerRow{"annealing-then-ceres",
                 "simulated-annealing, then a descent from its best point as in ceres-multistart",
                 OptimizerClass::Random, Evaluation::Curvature,
                 [](Options o) { return make_annealing_then_ceres({.annealing = {.common = o}}); }},
    OptimizerRow{"random-search", "Independent uniform points until the budget is spent: the floor",
                 OptimizerClass::Random, Evaluation::Value, [](Options o) { return make_random_search(o); }},
};

OptimizationReport report_of(const Evaluator& evaluator, RunOutcome outcome) {
    OptimizationReport report;
    report.termination = evaluator.trace().empty() ? Termination::Invalid : outcome.termination;
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
