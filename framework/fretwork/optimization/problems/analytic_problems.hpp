// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/optimization/problem.hpp>

#include <memory>
#include <vector>

namespace fretwork::optimization {

/// A problem with a minimum that is known in closed form.
struct AnalyticProblem {
    std::unique_ptr<Problem> problem;  ///< the function
    double best_value = 0.0;           ///< value of the global minimum
    Eigen::VectorXd best_point;        ///< point of the global minimum
};

/// Test functions from the literature: sphere, Rosenbrock, Powell's singular function, Beale, Rastrigin and
/// Levy (many minima), and a sum of distances with its minimum in a kink. Each problem offers every kind of
/// evaluation. No function has its minimum in the middle of its box, where some methods start.
std::vector<AnalyticProblem> analytic_problems();

}  // namespace fretwork::optimization
