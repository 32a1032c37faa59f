// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/borrowed.hpp>
#include <fretwork/reduction/calibration/calibration_problem.hpp>
#include <fretwork/reduction/calibration/model_response.hpp>

namespace fretwork::reduction {

/// The calibration of any tile model by its linear displacements. The tile is built and condensed at each
/// point; derivatives are central differences, but one-sided at a bound. The variables are the parameters, or
/// the natural logarithms of parameters with a logarithmic scale.
class DifferenceProblem final : public CalibrationProblem {
  public:
    /// Make the problem, which keeps references to model, tile and objective. Throws InputError if the bounds
    /// of a parameter are invalid. Throws as ModelTile::displacements() for a tile with all variables in the
    /// middle of their bounds, for example NumericalError if it is a mechanism under a scenario.
    DifferenceProblem(base::Borrowed<TileModel> model, base::Borrowed<ModelTile> tile,
                      base::Borrowed<Objective> objective, const Setting& setting);

    [[nodiscard]] std::string name() const override { return model_->name; }
    [[nodiscard]] const optimization::Bounds& bounds() const override { return bounds_; }
    [[nodiscard]] bool offers(optimization::Evaluation) const override { return true; }
    /// The number of tiles that an evaluation condenses: one for a value, and two more for each parameter if
    /// the evaluation has derivatives.
    [[nodiscard]] long cost(optimization::Evaluation kind) const override;
    [[nodiscard]] std::string cost_unit() const override { return "tiles condensed"; }
    [[nodiscard]] bool has_kinks() const override { return true; }
    [[nodiscard]] bool is_logarithm(int variable) const override;

    [[nodiscard]] double value(const Eigen::VectorXd& point) const override;
    [[nodiscard]] optimization::GradientEvaluation gradient(const Eigen::VectorXd& point,
                                                            double smoothing) const override;
    [[nodiscard]] optimization::ResidualEvaluation residuals(const Eigen::VectorXd& point,
                                                             double smoothing) const override;
    [[nodiscard]] optimization::CurvatureEvaluation curvature(const Eigen::VectorXd& point,
                                                              double smoothing) const override;

    [[nodiscard]] std::vector<double> parameter_values(const Eigen::VectorXd& point) const override;
    /// The displacements are not finite where ModelTile::displacements() throws NumericalError, for example
    /// because round-off makes the stiffness indefinite near the bounds.
    [[nodiscard]] UnitDisplacements displacements(const Eigen::VectorXd& point) const override;

  private:
    [[nodiscard]] UnitDisplacementsAndDerivatives derivatives(const Eigen::VectorXd& point) const;

    base::Borrowed<TileModel> model_;
    base::Borrowed<ModelTile> tile_;
    base::Borrowed<Objective> objective_;
    optimization::Bounds bounds_;
    UnitDisplacements not_finite_;
};

}  // namespace fretwork::reduction
