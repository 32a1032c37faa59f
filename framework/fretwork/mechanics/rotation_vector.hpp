// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>

namespace fretwork::mechanics {

/// The rotation about a vector by its length, rad.
inline Eigen::Quaterniond rotation_of(const Eigen::Vector3d& rotation_vector) {
    const double angle = rotation_vector.norm();
    if (angle == 0.0) return Eigen::Quaterniond::Identity();
    return Eigen::Quaterniond(Eigen::AngleAxisd(angle, rotation_vector / angle));
}

/// The inverse: a vector at most pi long.
inline Eigen::Vector3d rotation_vector_of(const Eigen::Quaterniond& rotation) {
    const Eigen::AngleAxisd turn(rotation.w() < 0.0 ? Eigen::Quaterniond(-rotation.coeffs()) : rotation);
    return turn.angle() * turn.axis();
}

}  // namespace fretwork::mechanics
