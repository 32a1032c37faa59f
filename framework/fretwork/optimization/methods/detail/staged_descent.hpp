// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/optimization/methods/multistart.hpp>

#include <functional>
#include <memory>

namespace fretwork::optimization::detail {

/// One descent, which goes on from stage to stage of the smoothing.
class StagedDescent {
  public:
    virtual ~StagedDescent() = default;
    /// Descend on the objective with its kinks rounded off by `smoothing`, to the stage's tolerance.
    virtual Ending run_stage(double smoothing) = 0;
    [[nodiscard]] virtual const Eigen::VectorXd& point() const = 0;
    /// Smoothed as in the last stage.
    [[nodiscard]] virtual double value() const = 0;
};

using MakeDescent = std::function<std::unique_ptr<StagedDescent>(Eigen::VectorXd start)>;

/// Run the descents from the best of the sampled points together, stage by stage. After each stage descents
/// that have met go on as one, and those far above the lowest end. See MultistartOptions.
RunOutcome run_multistart(Evaluator& evaluator, const MultistartOptions& options,
                          const MakeDescent& make_descent);

}  // namespace fretwork::optimization::detail
