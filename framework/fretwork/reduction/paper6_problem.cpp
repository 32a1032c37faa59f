// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/reduction/paper6_problem.hpp>

#include <cmath>
#include <numbers>

namespace fretwork::reduction {
namespace {

using Vector6 = Eigen::Matrix<double, 6, 1>;

double apothem(const Setting& setting) {
    return setting.tile_side / 2.0 / std::tan(std::numbers::pi / setting.sides);
}

}  // namespace

Paper6Bounds paper6_bounds(const Setting& setting) {
    constexpr double kSmallest = 0.001;
    constexpr double kLargest = 1000.0;
    const mechanics::Section& bar = setting.section;
    const double h = apothem(setting);
    return {{kSmallest * bar.area, kSmallest * bar.I2, kSmallest * bar.I3, kSmallest * bar.J,
             -std::numbers::pi / 6.0, 0.001 * h},
            {kLargest * bar.area, kLargest * bar.I2, kLargest * bar.I3, kLargest * bar.J,
             std::numbers::pi / 6.0, 0.999 * h}};
}

Paper6Problem::Paper6Problem(const Paper6Hexagon& model, const Objective& objective, const Setting& setting)
    : model_(model), objective_(objective), unit_{setting.section.area,
                                                  setting.section.I2,
                                                  setting.section.I3,
                                                  setting.section.J,
                                                  1.0,
                                                  apothem(setting)} {
    const Paper6Bounds limits = paper6_bounds(setting);
    bounds_ = {point(limits.lower), point(limits.upper)};
}

Paper6Problem::Paper6Problem(std::unique_ptr<const Paper6Hexagon> model, const Objective& objective,
                             const Setting& setting)
    : Paper6Problem(*model, objective, setting) {
    owned_model_ = std::move(model);
}

std::vector<double> Paper6Problem::parameter_values(const Eigen::VectorXd& x) const {
    return parameters(x).values();
}

UnitDisplacements Paper6Problem::displacements(const Eigen::VectorXd& x) const {
    return model_.displacements(parameters(x));
}

Paper6Parameters Paper6Problem::parameters(const Eigen::VectorXd& x) const {
    return {unit_.A * std::exp(x[0]), unit_.I2 * std::exp(x[1]), unit_.I3 * std::exp(x[2]),
            unit_.J * std::exp(x[3]), unit_.theta * x[4],        unit_.R * x[5]};
}

Eigen::VectorXd Paper6Problem::point(const Paper6Parameters& p) const {
    Vector6 x;
    x << std::log(p.A / unit_.A), std::log(p.I2 / unit_.I2), std::log(p.I3 / unit_.I3),
        std::log(p.J / unit_.J), p.theta / unit_.theta, p.R / unit_.R;
    return x;
}

double Paper6Problem::value(const Eigen::VectorXd& x) const {
    return objective_.value(displacements(x));
}

UnitDisplacementsAndDerivatives Paper6Problem::model_at(const Eigen::VectorXd& x) const {
    const Paper6Parameters p = parameters(x);
    auto model = model_.derivatives(p);
    Vector6 rates;  // of the parameters by the variables
    rates << p.A, p.I2, p.I3, p.J, unit_.theta, unit_.R;
    for (Eigen::MatrixXd& derivatives : model.derivatives) derivatives *= rates.asDiagonal();
    return model;
}

optimization::GradientEvaluation Paper6Problem::gradient(const Eigen::VectorXd& x, double smoothing) const {
    const auto model = curvature(x, smoothing);
    return {model.objective, model.value, model.gradient};
}

optimization::ResidualEvaluation Paper6Problem::residuals(const Eigen::VectorXd& x, double smoothing) const {
    return objective_.residuals(model_at(x), smoothing);
}

optimization::CurvatureEvaluation Paper6Problem::curvature(const Eigen::VectorXd& x, double smoothing) const {
    return objective_.curvature(model_at(x), smoothing);
}

}  // namespace fretwork::reduction
