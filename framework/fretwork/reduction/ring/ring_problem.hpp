// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/borrowed.hpp>
#include <fretwork/reduction/calibration/calibration_problem.hpp>
#include <fretwork/reduction/ring/ring_hexagon.hpp>

namespace fretwork::reduction {

/// The calibration of a ring with links to one pattern as a problem to be minimized. Variables: the natural
/// logarithms of sections as multiples of the setting's, theta in radians, and R as a share of the
/// centroid-to-side distance. An evaluation of any kind costs one factorization of the model's stiffness.
/// The gradient comes from one adjoint solution a scenario; residuals and curvature need one a parameter.
class RingProblem final : public CalibrationProblem {
  public:
    /// Keeps references to the model and the objective.
    RingProblem(base::Borrowed<RingHexagon> model, base::Borrowed<RingParameters> parameters,
                base::Borrowed<Objective> objective, const Setting& setting);
    /// Keeps a reference to the objective, and the model.
    RingProblem(std::unique_ptr<const RingHexagon> model, base::Borrowed<RingParameters> parameters,
                base::Borrowed<Objective> objective, const Setting& setting);

    [[nodiscard]] std::string name() const override;
    [[nodiscard]] const optimization::Bounds& bounds() const override { return bounds_; }
    [[nodiscard]] bool offers(optimization::Evaluation) const override { return true; }
    [[nodiscard]] std::string cost_unit() const override { return "stiffness factorizations"; }
    [[nodiscard]] bool has_kinks() const override { return true; }
    /// All but the last two.
    [[nodiscard]] bool is_logarithm(int variable) const override {
        return variable < static_cast<int>(units_.size()) - 2;
    }

    [[nodiscard]] double value(const Eigen::VectorXd& point) const override;
    [[nodiscard]] optimization::GradientEvaluation gradient(const Eigen::VectorXd& point,
                                                            double smoothing) const override;
    [[nodiscard]] optimization::ResidualEvaluation residuals(const Eigen::VectorXd& point,
                                                             double smoothing) const override;
    [[nodiscard]] optimization::CurvatureEvaluation curvature(const Eigen::VectorXd& point,
                                                              double smoothing) const override;

    [[nodiscard]] std::vector<double> parameter_values(const Eigen::VectorXd& point) const override;
    [[nodiscard]] UnitDisplacements displacements(const Eigen::VectorXd& point) const override;

    /// The point at which the parameters have these values.
    [[nodiscard]] Eigen::VectorXd point(std::span<const double> values) const;

  private:
    /// How the model's parts change with the variables.
    [[nodiscard]] RingDirections directions_at(std::span<const double> values) const;
    [[nodiscard]] UnitDisplacementsAndDerivatives model_at(const Eigen::VectorXd& point) const;

    std::unique_ptr<const RingHexagon> owned_model_;  ///< if it is not the caller's
    base::Borrowed<RingHexagon> model_;
    base::Borrowed<RingParameters> parameters_;
    base::Borrowed<Objective> objective_;
    Eigen::VectorXd units_;  ///< what the variables are multiples of
    optimization::Bounds bounds_;
};

}  // namespace fretwork::reduction
