// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/reduction/calibration_problem.hpp>
#include <fretwork/reduction/paper6_hexagon.hpp>

namespace fretwork::reduction {

/// The bounds of the six parameters: A, I2, I3, J within [0.001, 1000] times those of the setting's section
/// (Section 5.3); theta within 30 degrees; R within [0.001, 0.999] of the centroid-to-side distance, since at
/// the whole of it and theta = 0 the links would have no length (Eq. (7) allows that).
struct Paper6Bounds {
    Paper6Parameters lower;
    Paper6Parameters upper;
};
Paper6Bounds paper6_bounds(const Setting& setting);

/// The calibration of the paper's model to one pattern as a problem to be minimized. Variables: the natural
/// logarithms of A, I2, I3 and J as multiples of the section's, theta in radians, and R as a share of the
/// centroid-to-side distance. An evaluation of any kind costs one factorization of the model's stiffness.
class Paper6Problem final : public CalibrationProblem {
  public:
    /// Keeps references to the model and the objective.
    Paper6Problem(const Paper6Hexagon& model, const Objective& objective, const Setting& setting);
    /// Keeps a reference to the objective, and the model.
    Paper6Problem(std::unique_ptr<const Paper6Hexagon> model, const Objective& objective,
                  const Setting& setting);

    [[nodiscard]] std::string name() const override { return "paper6"; }
    [[nodiscard]] const optimization::Bounds& bounds() const override { return bounds_; }
    [[nodiscard]] bool offers(optimization::Evaluation) const override { return true; }
    [[nodiscard]] std::string cost_unit() const override { return "stiffness factorizations"; }
    [[nodiscard]] bool has_kinks() const override { return true; }
    [[nodiscard]] bool is_logarithm(int variable) const override { return variable < 4; }

    [[nodiscard]] double value(const Eigen::VectorXd& point) const override;
    [[nodiscard]] optimization::GradientEvaluation gradient(const Eigen::VectorXd& point,
                                                            double smoothing) const override;
    [[nodiscard]] optimization::ResidualEvaluation residuals(const Eigen::VectorXd& point,
                                                             double smoothing) const override;
    [[nodiscard]] optimization::CurvatureEvaluation curvature(const Eigen::VectorXd& point,
                                                              double smoothing) const override;

    [[nodiscard]] std::vector<double> parameter_values(const Eigen::VectorXd& point) const override;
    [[nodiscard]] UnitDisplacements displacements(const Eigen::VectorXd& point) const override;

    [[nodiscard]] Paper6Parameters parameters(const Eigen::VectorXd& point) const;
    [[nodiscard]] Eigen::VectorXd point(const Paper6Parameters& parameters) const;

  private:
    [[nodiscard]] UnitDisplacementsAndDerivatives model_at(const Eigen::VectorXd& point) const;

    std::unique_ptr<const Paper6Hexagon> owned_model_;  ///< if it is not the caller's
    const Paper6Hexagon& model_;
    const Objective& objective_;
    Paper6Parameters unit_;  ///< what the variables are multiples of
    optimization::Bounds bounds_;
};

}  // namespace fretwork::reduction
