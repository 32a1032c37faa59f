// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/optimization/problem.hpp>

#include <vector>

namespace fretwork::optimization::detail {

/// The scale of the unit box.
enum class Scale {
    Variable,  ///< the range between the bounds of the problem's variable
    Quantity,  ///< the range of exp(variable), for a variable that is a logarithm
};

/// A problem's box, scaled to a unit cube.
class UnitBox {
  public:
    explicit UnitBox(const Problem& problem, Scale scale = Scale::Variable);

    [[nodiscard]] int dimension() const { return bounds_.dimension(); }
    /// The point at these shares. A share that is outside the box by round-off is moved to the bound. A share
    /// that is farther outside stays, so that the evaluator refuses and counts the point.
    [[nodiscard]] Eigen::VectorXd point(const Eigen::VectorXd& shares) const;
    /// The derivative of the point with respect to the shares, variable by variable. Pre: Scale::Variable.
    [[nodiscard]] Eigen::VectorXd rates() const { return bounds_.upper - bounds_.lower; }

  private:
    Bounds bounds_;
    std::vector<bool> is_exponential_;
};

}  // namespace fretwork::optimization::detail
