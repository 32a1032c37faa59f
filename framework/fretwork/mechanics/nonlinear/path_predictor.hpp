// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/nonlinear/unknowns.hpp>

#include <deque>

namespace fretwork::mechanics::nonlinear {

/// Guesses the next equilibrium of a path from the last ones: the polynomial through up to three of them and
/// their rates (Hermite), continued. It is written in the unknowns' steps from the last equilibrium, so that
/// rotations of any size do no harm.
class PathPredictor {
  public:
    explicit PathPredictor(const Unknowns& unknowns) : unknowns_(unknowns) {}

    /// Add an equilibrium and the rate of its unknowns in the load factor.
    void add(double load_factor, const Configuration& configuration, const Eigen::VectorXd& rate);

    /// Forget what was before: the path goes on from elsewhere.
    void restart() { points_.clear(); }

    /// The step of the unknowns from the last equilibrium to that at another load factor.
    [[nodiscard]] Eigen::VectorXd step_to(double load_factor) const;

  private:
    struct Point {
        double load_factor;
        Configuration configuration;
        Eigen::VectorXd rate;
    };
    const Unknowns& unknowns_;
    std::deque<Point> points_;  ///< the last one first
};

}  // namespace fretwork::mechanics::nonlinear
