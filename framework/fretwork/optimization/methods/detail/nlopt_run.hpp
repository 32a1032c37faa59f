// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/optimization/optimizer.hpp>

#include <limits>
#include <nlopt.h>
#include <optional>

namespace fretwork::optimization::detail {

/// How a method of NLopt sees the objective.
enum class ObjectiveScale {
    AsItIs,
    /// asinh of it: its logarithm where it is large, itself near zero, and defined for every sign. The order
    /// of values stays. A method that takes its first step from the gradient needs it where the objective
    /// falls through many powers of ten: there is no length of a step in a slope of 1e10.
    Compressed,
};

/// One run of a method of NLopt. It works in the unit box.
struct NloptRun {
    nlopt_algorithm algorithm;
    std::optional<nlopt_algorithm> local{};  ///< of a method that descends by another one
    Eigen::VectorXd start;                   ///< shares of the box
    double initial_step = 0.1;               ///< share of the box
    ObjectiveScale scale = ObjectiveScale::AsItIs;
    /// The method's own criterion: relative changes of the objective, and of the shares; 0: none.
    double tolerance = 1e-8;
    long patience = std::numeric_limits<long>::max();  ///< evaluations without an improvement, then it ends
    std::uint32_t seed = 1;  ///< of methods that draw at random; NLopt's generator is the thread's own
};

/// Minimize the objective itself, without smoothing. A run that NLopt gives up at its first evaluation, or
/// that sees no finite value, ends as Invalid. Exceptions of the problem are thrown on.
RunOutcome run_nlopt(Evaluator& evaluator, const NloptRun& run);

}  // namespace fretwork::optimization::detail
