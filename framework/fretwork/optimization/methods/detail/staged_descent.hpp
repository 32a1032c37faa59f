// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/optimization/methods/multistart.hpp>

#include <functional>
#include <memory>

namespace fretwork::optimization::detail {

/// A descent by continuation, stage by stage; each stage has less smoothing than the stage before.
class StagedDescent {
  public:
    virtual ~StagedDescent() = default;
    /// Minimize the objective with its kinks rounded by `smoothing`, to the tolerance of the stage.
    virtual Ending run_stage(double smoothing) = 0;
    [[nodiscard]] virtual const Eigen::VectorXd& point() const = 0;
    /// The objective at point(), smoothed as in the latest call of run_stage().
    [[nodiscard]] virtual double value() const = 0;
};

using MakeDescent = std::function<std::unique_ptr<StagedDescent>(Eigen::VectorXd start)>;

/// Run descents together, stage by stage, from the best of the sampled points. After each stage, descents
/// that have met continue as one, and a descent far above the lowest descent ends. See MultistartOptions.
RunOutcome run_multistart(Evaluator& evaluator, const MultistartOptions& options,
                          const MakeDescent& make_descent);

}  // namespace fretwork::optimization::detail
