// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/reduction/detail/rotation.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace fretwork::reduction::detail {

GrowingRotation::GrowingRotation(const Eigen::Vector3d& rate)
    : rate_(rate.norm()), axis_(rate / std::max(rate_, std::numeric_limits<double>::min())) {}

void GrowingRotation::set_step(double magnitude) {
    step_angle_ = magnitude * rate_;
    step_sine_ = std::sin(step_angle_ / 2.0);
    step_cosine_ = std::cos(step_angle_ / 2.0);
}

Eigen::Matrix3d GrowingRotation::right_jacobian() const {
    if (angle_ == 0.0) return Eigen::Matrix3d::Identity();
    // (sin t / t) (1 - a a^T) + a a^T - ((1 - cos t) / t) [a], where t is the angle, a the axis and [a] the
    // matrix of its cross product. Sine and cosine of t follow from sine and cosine of t/2.
    const double along = 2.0 * sine_ * cosine_ / angle_;
    const Eigen::Vector3d across = 2.0 * sine_ * sine_ / angle_ * axis_;
    Eigen::Matrix3d jacobian = (1.0 - along) * axis_ * axis_.transpose();
    jacobian.diagonal().array() += along;
    jacobian(0, 1) += across.z();
    jacobian(1, 0) -= across.z();
    jacobian(0, 2) -= across.y();
    jacobian(2, 0) += across.y();
    jacobian(1, 2) += across.x();
    jacobian(2, 1) -= across.x();
    return jacobian;
}

double AngleSum::value() const {
    return quarters_ * (std::numbers::pi / 2.0) + std::atan2(sine_, cosine_);
}

}  // namespace fretwork::reduction::detail
