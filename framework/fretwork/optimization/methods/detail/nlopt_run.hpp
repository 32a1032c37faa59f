// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/optimization/optimizer.hpp>

#include <limits>
#include <nlopt.h>
#include <optional>

namespace fretwork::optimization::detail {

/// The scale on which a method of NLopt sees the objective.
enum class ObjectiveScale {
    AsItIs,
    /// The inverse hyperbolic sine of the objective: about its logarithm if it is large, about the objective
    /// itself near zero, and defined for both signs. The order of values stays the same. Some methods take
    /// their first step from the gradient. They need this scale if the objective falls through many powers of
    /// ten: a slope of 1e10 gives no useful step length.
    Compressed,
};

/// One run of a method of NLopt. It works in the unit box.
struct NloptRun {
    nlopt_algorithm algorithm;
    /// Method of the descents, for a method that descends by another method.
    std::optional<nlopt_algorithm> local{};
    Eigen::VectorXd start;      ///< shares of the box
    double initial_step = 0.1;  ///< share of the box
    ObjectiveScale scale = ObjectiveScale::AsItIs;
    /// The method's own criterion: the relative changes of the objective and of the shares; 0: no criterion.
    double tolerance = 1e-8;
    /// Number of evaluations without an improvement after which the run ends.
    long patience = std::numeric_limits<long>::max();
    std::uint32_t seed = 1;  ///< seed of methods that draw at random; NLopt has one generator for each thread
};

/// Minimize the objective without smoothing. A run that NLopt gives up at its first evaluation, or that gets
/// no finite value, ends as Invalid. Exceptions of the problem are passed on.
RunOutcome run_nlopt(Evaluator& evaluator, const NloptRun& run);

}  // namespace fretwork::optimization::detail
