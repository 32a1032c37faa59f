// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/borrowed.hpp>
#include <fretwork/reduction/calibration/calibration_problem.hpp>
#include <fretwork/reduction/ring/ring_hexagon.hpp>

namespace fretwork::reduction {

/// The minimization problem by which a ring with links is calibrated to one pattern. The variables are the
/// natural logarithms of A, I2, I3 and J as multiples of the setting's values, theta in radians, and R as a
/// share of the centroid-to-side distance. An evaluation of any kind counts as one factorization of the
/// model's stiffness. A gradient takes one further (adjoint) solution for each scenario. Residuals and
/// curvature take one further solution for each scenario and parameter.
class RingProblem final : public CalibrationProblem {
  public:
    /// Make a problem that keeps references to the model, the parameters and the objective.
    RingProblem(base::Borrowed<RingHexagon> model, base::Borrowed<RingParameters> parameters,
                base::Borrowed<Objective> objective, const Setting& setting);
    /// Make a problem that owns the model, and keeps references to the parameters and the objective.
    RingProblem(std::unique_ptr<const RingHexagon> model, base::Borrowed<RingParameters> parameters,
                base::Borrowed<Objective> objective, const Setting& setting);

    [[nodiscard]] std::string name() const override;
    [[nodiscard]] const optimization::Bounds& bounds() const override { return bounds_; }
    [[nodiscard]] bool offers(optimization::Evaluation) const override { return true; }
    [[nodiscard]] std::string cost_unit() const override { return "stiffness factorizations"; }
    [[nodiscard]] bool has_kinks() const override { return true; }
    /// True for all variables but the last two, theta and R.
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
    /// The derivatives of the ring's parts with respect to the variables.
    [[nodiscard]] RingDirections directions_at(std::span<const double> values) const;
    [[nodiscard]] UnitDisplacementsAndDerivatives model_at(const Eigen::VectorXd& point) const;

    std::unique_ptr<const RingHexagon> owned_model_;  ///< null if the caller owns the model
    base::Borrowed<RingHexagon> model_;
    base::Borrowed<RingParameters> parameters_;
    base::Borrowed<Objective> objective_;
    Eigen::VectorXd units_;  ///< the scale of each parameter (ring_units)
    optimization::Bounds bounds_;
};

}  // namespace fretwork::reduction
