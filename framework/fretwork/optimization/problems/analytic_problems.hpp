// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/optimization/problem.hpp>

#include <memory>
#include <vector>

namespace fretwork::optimization {

/// A problem whose minimum is known in closed form.
struct AnalyticProblem {
    std::unique_ptr<Problem> problem;  ///< the function
    double best_value = 0.0;           ///< its global minimum
    Eigen::VectorXd best_point;        ///< where that is
};

/// Test functions of the literature with every kind of evaluation: sphere, Rosenbrock, Powell's singular one,
/// Beale, Rastrigin and Levy (many minima), and a sum of distances with its minimum in a kink. No optimum
/// lies in the middle of its box, because some methods start there.
std::vector<AnalyticProblem> analytic_problems();

}  // namespace fretwork::optimization
