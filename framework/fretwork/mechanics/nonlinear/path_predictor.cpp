// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/mechanics/nonlinear/path_predictor.hpp>

#include <vector>

namespace fretwork::mechanics::nonlinear {
namespace {

constexpr std::size_t kPoints = 3;

/// The third equilibrium is used only if its correction is at most this share of the second's correction.
/// Near a limit load, a polynomial of higher degree overshoots.
constexpr double kSmallCorrection = 0.3;

}  // namespace

void PathPredictor::add(double load_factor, const Configuration& configuration, const Eigen::VectorXd& rate) {
    points_.push_front({load_factor, configuration, rate});
    if (points_.size() > kPoints) points_.pop_back();
}

Eigen::VectorXd PathPredictor::step_to(double load_factor) const {
    // Newton's form of the polynomial: each equilibrium appears twice, and the divided difference of the two
    // is the rate.
    const std::size_t count = 2 * points_.size();
    std::vector<double> at(count);
    std::vector<Eigen::VectorXd> value(count);
    std::vector<Eigen::VectorXd> difference(count);
    for (std::size_t i = 0; i < count; ++i) {
        const Point& point = points_[i / 2];
        at[i] = point.load_factor;
        if (i % 2 == 1) {
            value[i] = value[i - 1];
            difference[i] = i == 1 ? point.rate : unknowns_.rate_of_steps(value[i], point.rate);
            continue;
        }
        value[i] = i == 0 ? Eigen::VectorXd::Zero(point.rate.size())
                          : unknowns_.step_between(points_[0].configuration, point.configuration);
        if (i > 0) difference[i] = (value[i] - value[i - 1]) / (at[i] - at[i - 1]);
    }
    Eigen::VectorXd step = Eigen::VectorXd::Zero(points_[0].rate.size());
    double product = 1.0;
    std::vector<double> added;
    for (std::size_t order = 1; order < count; ++order) {
        product *= load_factor - at[order - 1];
        if (order > 1) {
            for (std::size_t i = count; i-- > order;)
                difference[i] = (difference[i] - difference[i - 1]) / (at[i] - at[i - order]);
        }
        const Eigen::VectorXd term = product * difference[order];
        added.push_back(unknowns_.largest_component(term));
        if (order >= 4 && added.back() > kSmallCorrection * (added[1] + added[2])) break;
        step += term;
    }
    return step;
}

}  // namespace fretwork::mechanics::nonlinear
