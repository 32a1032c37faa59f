// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/optimization/problem.hpp>

#include <vector>

namespace fretwork::optimization::detail {

/// The scale of the unit box.
enum class Scale {
    Variable,  ///< the way between the bounds of the problem's variable
    Quantity,  ///< the same of exp(variable), where the variable is a logarithm
};

/// A problem's box as a unit cube, in which all variables are alike.
class UnitBox {
  public:
    explicit UnitBox(const Problem& problem, Scale scale = Scale::Variable);

    [[nodiscard]] int dimension() const { return bounds_.dimension(); }
    /// The point at these shares. A share outside the box by round-off is put on the bound; one that is
    /// farther outside stays there, so that the evaluator refuses and counts it.
    [[nodiscard]] Eigen::VectorXd point(const Eigen::VectorXd& shares) const;
    /// The change of the point by the shares, variable by variable. Pre: Scale::Variable.
    [[nodiscard]] Eigen::VectorXd rates() const { return bounds_.upper - bounds_.lower; }

  private:
    Bounds bounds_;
    std::vector<bool> is_exponential_;
};

}  // namespace fretwork::optimization::detail
