// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/nonlinear/unknowns.hpp>

#include <deque>

namespace fretwork::mechanics::nonlinear {

/// Predicts the next equilibrium of a path. It extrapolates the Hermite polynomial through up to three last
/// equilibria and their rates. The polynomial's values are steps of the unknowns from the last equilibrium,
/// so rotations may have any size.
class PathPredictor {
  public:
    explicit PathPredictor(const Unknowns& unknowns) : unknowns_(unknowns) {}

    /// Add an equilibrium and the derivative of its unknowns with respect to the load factor.
    void add(double load_factor, const Configuration& configuration, const Eigen::VectorXd& rate);

    /// Forget all equilibria, because the path continues elsewhere.
    void restart() { points_.clear(); }

    /// The predicted step of the unknowns from the last equilibrium to the equilibrium at another load
    /// factor.
    [[nodiscard]] Eigen::VectorXd step_to(double load_factor) const;

  private:
    struct Point {
        double load_factor;
        Configuration configuration;
        Eigen::VectorXd rate;
    };
    const Unknowns& unknowns_;
    std::deque<Point> points_;  ///< added equilibria, the last equilibrium first
};

}  // namespace fretwork::mechanics::nonlinear
