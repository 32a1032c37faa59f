// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/named.hpp>
#include <fretwork/optimization/methods/annealing_then_ceres.hpp>
#include <fretwork/optimization/methods/ceres_residuals.hpp>
#include <fretwork/optimization/methods/detail/nlopt_optimizer.hpp>
#include <fretwork/optimization/methods/multistart.hpp>
#include <fretwork/optimization/methods/pagmo_methods.hpp>
#include <fretwork/optimization/methods/random_search.hpp>
#include <fretwork/optimization/methods/simulated_annealing.hpp>
#include <fretwork/optimization/optimizer_catalogue.hpp>

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace fretwork::optimization {
namespace {

using Made = std::unique_ptr<Optimizer>;
using Options = const OptimizerOptions&;

/// Simulated annealing with these options, but with `common`.
Made annealing(SimulatedAnnealingOptions options, Options common) {
    options.common = common;
    return make_simulated_annealing(options);
}

Made ceres_residuals(CeresResidualsOptions options, Options common) {
    options.common = common;
    return make_ceres_residuals(options);
}

/// The smoothing of ceres-multistart's continuation stages. The row ceres-smoothed and its variants have the
/// same stages, so a comparison with ceres-multistart does not depend on the stages.
std::vector<double> stages() {
    return ContinuationOptions{}.smoothing;
}

/// Descents by a method of NLopt, or repetitions of a method that draws at random.
template <nlopt_algorithm kMethod>
Made nlopt_runs(Options common) {
    return detail::make_nlopt_runs(kMethod, {.common = common});
}

/// Descents by a method of NLopt whose steps follow gradients. The method gets the compressed objective,
/// because the objective of a calibration falls from 1e10 to 1.
template <nlopt_algorithm kMethod>
Made nlopt_descents(Options common) {
    return detail::make_nlopt_runs(kMethod, {.common = common, .scale = detail::ObjectiveScale::Compressed});
}

/// One search of the whole box by a method of NLopt. The search ends by NloptOptions::patience. If `kLocal`
/// is given, the method descends by `kLocal`, which follows gradients.
template <nlopt_algorithm kMethod, nlopt_algorithm... kLocal>
Made nlopt_search(Options common) {
    std::optional<nlopt_algorithm> local;
    ((local = kLocal), ...);
    using enum detail::ObjectiveScale;
    return detail::make_nlopt_search(kMethod, local,
                                     {.common = common, .scale = local ? Compressed : AsItIs});
}

const std::array kRows = {
    OptimizerRow{"ceres-multistart",
                 "Ceres Levenberg-Marquardt with bounds, from screened starting points; a continuation "
                 "smooths the kinks of the objective and keeps the curvature of its norms",
                 OptimizerClass::Local, Evaluation::Curvature,
                 [](Options o) { return make_ceres_multistart({.common = o}); }},
    OptimizerRow{
        "gauss-newton-multistart",
        "As ceres-multistart, but with our own projected trust-region step, which is exact at the bounds",
        OptimizerClass::Local, Evaluation::Curvature,
        [](Options o) { return make_gauss_newton_multistart({.common = o}); }},
    OptimizerRow{"ceres-residuals",
                 "Ceres Levenberg-Marquardt with bounds; it uses the residuals unsmoothed, and starts from "
                 "low-discrepancy points",
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
    // [Powell2009]
    OptimizerRow{"bobyqa", "BOBYQA of NLopt; it uses values only, and starts from low-discrepancy points",
                 OptimizerClass::Local, Evaluation::Value, nlopt_runs<NLOPT_LN_BOBYQA>},
    // [Rowan1990]
    OptimizerRow{"subplex", "Subplex of NLopt; it uses values only, and starts from low-discrepancy points",
                 OptimizerClass::Local, Evaluation::Value, nlopt_runs<NLOPT_LN_SBPLX>},
    // [Kraft1994]
    OptimizerRow{"slsqp", "SLSQP of NLopt; it uses gradients, and starts from low-discrepancy points",
                 OptimizerClass::Local, Evaluation::Gradient, nlopt_descents<NLOPT_LD_SLSQP>},
    // [Gablonsky2001]
    OptimizerRow{"direct-l", "DIRECT-L of NLopt, which divides the box of the bounds again and again",
                 OptimizerClass::Global, Evaluation::Value, nlopt_search<NLOPT_GN_DIRECT_L>},
    // [RinnooyKan1987, Kucherenko2005]. The time of its clustering grows with the square of the number of
    // points.
    OptimizerRow{"mlsl", "Multi-level single linkage of NLopt: Sobol points and SLSQP",
                 OptimizerClass::Global, Evaluation::Gradient,
                 nlopt_search<NLOPT_G_MLSL_LDS, NLOPT_LD_SLSQP>},
    // [Kaelo2006]
    OptimizerRow{"crs2", "Controlled random search with local mutation of NLopt", OptimizerClass::Random,
                 Evaluation::Value, nlopt_runs<NLOPT_GN_CRS2_LM>},
    OptimizerRow{"cma-es", "CMA-ES of pagmo; each restart doubles the population", OptimizerClass::Random,
                 Evaluation::Value, [](Options o) { return make_cma_es({.common = o}); }},
    OptimizerRow{"differential-evolution", "Differential evolution rand/1/exp of pagmo",
                 OptimizerClass::Random, Evaluation::Value,
                 [](Options o) { return make_differential_evolution({.common = o}); }},
    OptimizerRow{"simulated-annealing",
                 "Simulated annealing with the algorithm and the defaults of ensmallen, in the unit box; "
                 "moves are reflected at the bounds",
                 OptimizerClass::Random, Evaluation::Value, [](Options o) { return annealing({}, o); }},
    OptimizerRow{"annealing-clamp", "As simulated-annealing, but a move beyond a bound ends on the bound",
                 OptimizerClass::Random, Evaluation::Value,
                 [](Options o) { return annealing({.bounds = AnnealingBounds::Clamp}, o); }},
    OptimizerRow{"annealing-reject", "As simulated-annealing; a move beyond a bound is rejected",
                 OptimizerClass::Random, Evaluation::Value,
                 [](Options o) { return annealing({.bounds = AnnealingBounds::Reject}, o); }},
    OptimizerRow{"annealing-raw",
                 "As simulated-annealing, but the variables are the parameters instead of their logarithms",
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
    OptimizerRow{"random-search", "Independent uniform points until the budget is spent: the baseline",
                 OptimizerClass::Random, Evaluation::Value, [](Options o) { return make_random_search(o); }},
};

}  // namespace

std::span<const OptimizerRow> optimizer_catalogue() {
    return kRows;
}

const OptimizerRow& find_optimizer(std::string_view name, std::span<const OptimizerRow> rows) {
    return base::find_named(name, rows, &OptimizerRow::name, "optimizer");
}

}  // namespace fretwork::optimization
