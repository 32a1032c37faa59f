// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/optimization/methods/detail/ceres_solve.hpp>
#include <fretwork/optimization/methods/detail/staged_descent.hpp>

namespace fretwork::optimization::detail {

/// A descent by Ceres on the problem's generalized Gauss-Newton model. See make_ceres_multistart.
class CeresDescent final : public StagedDescent {
  public:
    /// The evaluator and the options have to outlive the descent.
    CeresDescent(Evaluator& evaluator, const ContinuationOptions& options, Eigen::VectorXd start);

    Ending run_stage(double smoothing) override;
    [[nodiscard]] const Eigen::VectorXd& point() const override { return point_; }
    [[nodiscard]] double value() const override { return value_; }

  private:
    Evaluator& evaluator_;
    const ContinuationOptions& options_;
    Eigen::VectorXd point_;
    double value_;
    double trust_region_radius_;  ///< kept from one continuation stage to the next
};

}  // namespace fretwork::optimization::detail
