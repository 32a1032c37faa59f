// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/casters.hpp"

#include <fretwork/optimization/problem.hpp>

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>

namespace fretwork::python {

/// The objective at a point.
using ValueFunction = std::function<double(const Eigen::VectorXd&)>;
/// The objective and its gradient at a point.
using GradientFunction = std::function<std::pair<double, Eigen::VectorXd>(const Eigen::VectorXd&)>;
/// The residuals and their Jacobian at a point. The objective is the squared norm of the residuals.
using ResidualFunction = std::function<std::pair<Eigen::VectorXd, Eigen::MatrixXd>(const Eigen::VectorXd&)>;

/// A problem of Python functions. Throws InputError unless all bounds are finite and lower < upper.
std::shared_ptr<optimization::Problem> make_problem(std::string name, Eigen::VectorXd lower,
                                                    Eigen::VectorXd upper, ValueFunction value,
                                                    std::optional<GradientFunction> gradient,
                                                    std::optional<ResidualFunction> residuals);

/// Throws InputError unless the point has as many numbers as the problem has variables.
void check_dimension(const optimization::Problem& problem, const Eigen::VectorXd& point);

}  // namespace fretwork::python
