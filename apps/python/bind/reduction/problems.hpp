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

using ValueFunction = std::function<double(const Eigen::VectorXd&)>;
using GradientFunction = std::function<std::pair<double, Eigen::VectorXd>(const Eigen::VectorXd&)>;
using ResidualFunction = std::function<std::pair<Eigen::VectorXd, Eigen::MatrixXd>(const Eigen::VectorXd&)>;

/// A problem of Python functions.
std::shared_ptr<optimization::Problem> make_problem(std::string name, Eigen::VectorXd lower,
                                                    Eigen::VectorXd upper, ValueFunction value,
                                                    std::optional<GradientFunction> gradient,
                                                    std::optional<ResidualFunction> residuals);

/// Throws InputError unless the point has as many numbers as the problem has variables.
void check_dimension(const optimization::Problem& problem, const Eigen::VectorXd& point);

}  // namespace fretwork::python
