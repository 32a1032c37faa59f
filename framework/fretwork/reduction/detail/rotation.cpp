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

RotationRate rotation_rate(const Eigen::Vector3d& vector) {
    const double square = vector.squaredNorm();
    double first = 0.5 - square / 24.0;          // (1 - cos t) / t^2
    double second = 1.0 / 6.0 - square / 120.0;  // (t - sin t) / t^3
    Eigen::Quaterniond rotation;
    if (square < kSmallSquare) {
        rotation = rotation_of(vector);
    } else {
        // One sine and cosine, of the half angle, give all.
        const double angle = std::sqrt(square);
        const double sine = std::sin(angle / 2.0);
        const double cosine = std::cos(angle / 2.0);
        const Eigen::Vector3d half = sine / angle * vector;
        rotation = {cosine, half.x(), half.y(), half.z()};
        first = 2.0 * sine * sine / square;
        second = (angle - 2.0 * sine * cosine) / (square * angle);
    }
    // 1 - first [v] + second [v]^2, where [v]^2 = v v^T - |v|^2.
    Eigen::Matrix3d jacobian = second * vector * vector.transpose();
    jacobian.diagonal().array() += 1.0 - second * square;
    jacobian(0, 1) += first * vector.z();
    jacobian(1, 0) -= first * vector.z();
    jacobian(0, 2) -= first * vector.y();
    jacobian(2, 0) += first * vector.y();
    jacobian(1, 2) += first * vector.x();
    jacobian(2, 1) -= first * vector.x();
    return {rotation, jacobian};
}

}  // namespace fretwork::reduction::detail
