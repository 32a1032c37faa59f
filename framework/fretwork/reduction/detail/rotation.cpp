// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/reduction/detail/rotation.hpp>

#include <cmath>

namespace fretwork::reduction::detail {
namespace {

/// Below this square of an angle the series are exact to round-off.
constexpr double kSmallSquare = 1e-8;

}  // namespace

Eigen::Quaterniond rotation_of(const Eigen::Vector3d& vector) {
    const double square = vector.squaredNorm();
    if (square < kSmallSquare) {
        const Eigen::Vector3d half = (0.5 - square / 48.0) * vector;
        return {1.0 - square / 8.0, half.x(), half.y(), half.z()};
    }
    const double angle = std::sqrt(square);
    const Eigen::Vector3d half = std::sin(angle / 2.0) / angle * vector;
    return {std::cos(angle / 2.0), half.x(), half.y(), half.z()};
}

Eigen::Vector3d rotation_vector(const Eigen::Quaterniond& rotation) {
    const double sine = rotation.vec().norm();
    const double sign = rotation.w() < 0.0 ? -1.0 : 1.0;
    if (sine * sine < kSmallSquare) return sign * (2.0 + sine * sine / 3.0) * rotation.vec();
    return sign * 2.0 * std::atan2(sine, std::abs(rotation.w())) / sine * rotation.vec();
}

Eigen::Matrix3d right_jacobian(const Eigen::Vector3d& vector) {
    const double square = vector.squaredNorm();
    double first = 0.5 - square / 24.0;          // (1 - cos t) / t^2
    double second = 1.0 / 6.0 - square / 120.0;  // (t - sin t) / t^3
    if (square >= kSmallSquare) {
        const double angle = std::sqrt(square);
        first = (1.0 - std::cos(angle)) / square;
        second = (angle - std::sin(angle)) / (square * angle);
    }
    Eigen::Matrix3d cross;
    cross << 0, -vector.z(), vector.y(), vector.z(), 0, -vector.x(), -vector.y(), vector.x(), 0;
    return Eigen::Matrix3d::Identity() - first * cross + second * cross * cross;
}

}  // namespace fretwork::reduction::detail
