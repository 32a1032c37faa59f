// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/optimization/problem.hpp>
#include <fretwork/reduction/calibration/objective.hpp>

#include <vector>

namespace fretwork::reduction {

/// The calibration of a tile model as a problem to be minimized: E of Eq. (8) over the model's parameters.
/// The variables of the problem may differ from the parameters: they may be logarithms, for example.
class CalibrationProblem : public optimization::Problem {
  public:
    /// The parameters at a point of the variables, SI, in the order of the model's row.
    [[nodiscard]] virtual std::vector<double> parameter_values(const Eigen::VectorXd& point) const = 0;
    /// The displacements of the model at a point of the variables.
    [[nodiscard]] virtual UnitDisplacements displacements(const Eigen::VectorXd& point) const = 0;
};

}  // namespace fretwork::reduction
