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

double AngleSum::value() const {
    return quarters_ * (std::numbers::pi / 2.0) + std::atan2(sine_, cosine_);
}

}  // namespace fretwork::reduction::detail
