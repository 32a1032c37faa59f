// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/geometry/rotation.hpp>

#include <cmath>
#include <limits>
#include <numbers>

namespace fretwork::geometry {
namespace {

/// The square of the angle below which the closed forms lose digits and the series are exact to rounding.
constexpr double kSmallSquare = 0.04;

/// The coefficients of T = I + first [v] + second [v]^2 at |v|^2 = x, and their derivatives by x.
struct SpinCoefficients {
    double first;   ///< (1 - cos a) / a^2
    double second;  ///< (a - sin a) / a^3
    double first_slope;
    double second_slope;
};

SpinCoefficients series_coefficients(double x) {
    return {1.0 / 2 - x / 24 * (1 - x / 30 * (1 - x / 56 * (1 - x / 90))),
            1.0 / 6 - x / 120 * (1 - x / 42 * (1 - x / 72 * (1 - x / 110))),
            -1.0 / 24 * (1 - x / 15 * (1 - x / 56 * (1.5 - x / 45))),
            -1.0 / 120 * (1 - x / 21 * (1 - x / 72 * (1.5 - x / 55)))};
}

SpinCoefficients spin_coefficients(double x) {
    if (x < kSmallSquare) return series_coefficients(x);
    const double angle = std::sqrt(x);
    const double half_sine = std::sin(angle / 2);
    const double first = 2.0 * half_sine * half_sine / x;
    const double second = (angle - std::sin(angle)) / (x * angle);
    // d/dx = d/da / (2 a)
    const double first_slope = (std::sin(angle) / angle - 2.0 * first) / (2.0 * x);
    const double second_slope = (first - 3.0 * second) / (2.0 * x);
    return {first, second, first_slope, second_slope};
}

double series_of_second(double x) {
    return 1.0 / 12 + x / 720 * (1 + x / 42 * (1 + x / 40));
}

/// 1 - [v] / 2 + second [v]^2
Eigen::Matrix3d inverse_map_of(const Eigen::Vector3d& v, double second) {
    Eigen::Matrix3d map = -0.5 * cross_matrix(v) + second * v * v.transpose();
    map.diagonal().array() += 1.0 - second * v.squaredNorm();
    return map;
}

}  // namespace

Eigen::MatrixXd rigid_motions(const Eigen::Ref<const Eigen::Matrix3Xd>& points) {
    Eigen::MatrixXd motions = Eigen::MatrixXd::Zero(6 * points.cols(), 6);
    for (Eigen::Index i = 0; i < points.cols(); ++i) {
        motions.block<6, 6>(6 * i, 0).setIdentity();
        motions.block<3, 3>(6 * i, 3) = -cross_matrix(points.col(i));
    }
    return motions;
}

Eigen::Quaterniond exponential(const Eigen::Vector3d& v) {
    const double half = 0.5 * v.norm();
    const double ratio = half < 1e-4 ? 0.5 * (1.0 - half * half / 6.0) : 0.5 * std::sin(half) / half;
    Eigen::Quaterniond q(std::cos(half), ratio * v.x(), ratio * v.y(), ratio * v.z());
    q.normalize();
    return q;
}

Eigen::Vector3d logarithm(const Eigen::Quaterniond& rotation) {
    const double sign = rotation.w() < 0 ? -1.0 : 1.0;
    const double sine = rotation.vec().norm();
    const double half = std::atan2(sine, sign * rotation.w());
    const double ratio = sine < 1e-8 ? 2.0 / (sign * rotation.w()) : 2.0 * half / sine;
    return sign * ratio * rotation.vec();
}

Eigen::Vector3d logarithm_near(const Eigen::Quaterniond& rotation, const Eigen::Vector3d& reference) {
    constexpr double kTurn = 2.0 * std::numbers::pi;
    Eigen::Vector3d least = logarithm(rotation);
    const double reference_angle = reference.norm();
    if (reference_angle < 1.0) return least;
    const double angle = least.norm();
    // At whole turns, the rotation has no axis, and the reference's axis is used.
    const Eigen::Vector3d axis = angle > std::numeric_limits<double>::epsilon()
                                     ? Eigen::Vector3d(least / angle)
                                     : Eigen::Vector3d(reference / reference_angle);
    const double turns = std::round((axis.dot(reference) - angle) / kTurn);
    return (angle + turns * kTurn) * axis;
}

Eigen::Matrix3d spin_map(const Eigen::Vector3d& v) {
    const SpinCoefficients c = spin_coefficients(v.squaredNorm());
    // [v]^2 = v v^T - |v|^2 I
    Eigen::Matrix3d map = c.first * cross_matrix(v) + c.second * v * v.transpose();
    map.diagonal().array() += 1.0 - c.second * v.squaredNorm();
    return map;
}

Eigen::Matrix3d inverse_spin_map(const Eigen::Vector3d& v) {
    const double x = v.squaredNorm();
    const double half = 0.5 * std::sqrt(x);
    return inverse_map_of(v, x < kSmallSquare ? series_of_second(x) : (1.0 - half / std::tan(half)) / x);
}

LogarithmWithMap logarithm_with_map(const Eigen::Quaterniond& rotation) {
    const Eigen::Vector3d v = logarithm(rotation);
    const double x = v.squaredNorm();
    if (x < kSmallSquare) return {v, inverse_map_of(v, series_of_second(x))};
    // The vector part of the quaternion over its scalar part is the tangent of the half angle.
    const double ratio = rotation.vec().dot(v) / rotation.vec().squaredNorm();
    return {v, inverse_map_of(v, (1.0 - 0.5 * ratio * rotation.w()) / x)};
}

Eigen::Matrix3d spin_map_derivative(const Eigen::Vector3d& v, const Eigen::Vector3d& a) {
    const SpinCoefficients c = spin_coefficients(v.squaredNorm());
    const Eigen::Vector3d va = v.cross(a);
    const Eigen::Vector3d vva = v.cross(va);
    // T^T a = a - first v x a + second v x (v x a), and d|v|^2 = 2 v . dv
    Eigen::Matrix3d derivative = c.first * cross_matrix(a) - 2.0 * c.first_slope * va * v.transpose();
    derivative += c.second * (-cross_matrix(va) - cross_matrix(v) * cross_matrix(a));
    derivative += 2.0 * c.second_slope * vva * v.transpose();
    return derivative;
}

}  // namespace fretwork::geometry
