// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>

namespace fretwork::reduction::detail {

/// The rotation of a rotation vector.
Eigen::Quaterniond rotation_of(const Eigen::Vector3d& vector);
/// The rotation vector of a rotation, at most pi long.
Eigen::Vector3d rotation_vector(const Eigen::Quaterniond& rotation);
/// A rotation, and how it changes: J with exp(v + dv) = exp(v) exp(J dv) to first order.
struct RotationRate {
    Eigen::Quaterniond rotation;
    Eigen::Matrix3d right_jacobian;
};
RotationRate rotation_rate(const Eigen::Vector3d& vector);

}  // namespace fretwork::reduction::detail
