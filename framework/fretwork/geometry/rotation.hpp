// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace fretwork::geometry {

/// The matrix [v] with [v] w = v x w.
inline Eigen::Matrix3d cross_matrix(const Eigen::Vector3d& v) {
    Eigen::Matrix3d m;
    m << 0.0, -v.z(), v.y(), v.z(), 0.0, -v.x(), -v.y(), v.x(), 0.0;
    return m;
}

/// The six small rigid motions of points: displacements along the axes, then rotations about the axes through
/// the origin, one in each column. A point has six rows: its displacement and its rotation vector.
Eigen::MatrixXd rigid_motions(const Eigen::Ref<const Eigen::Matrix3Xd>& points);

/// The rotation that a rotation vector of any length describes.
Eigen::Quaterniond exponential(const Eigen::Vector3d& rotation_vector);

/// The rotation vector of a rotation, with a length of at most pi.
Eigen::Vector3d logarithm(const Eigen::Quaterniond& rotation);

/// The rotation vector of a rotation that is nearest to `reference`; logarithm() if `reference` is shorter
/// than 1 rad. The vectors of a rotation differ by whole turns. Along a path of small steps, this vector has
/// no jumps and counts the turns.
Eigen::Vector3d logarithm_near(const Eigen::Quaterniond& rotation, const Eigen::Vector3d& reference);

/// The matrix T that maps a small change dv of a rotation vector v to the infinitesimal rotation T dv about
/// fixed axes. To first order in dv, exp(v + dv) = exp(T dv) exp(v).
Eigen::Matrix3d spin_map(const Eigen::Vector3d& rotation_vector);

/// The inverse of spin_map(), for rotations below a whole turn.
Eigen::Matrix3d inverse_spin_map(const Eigen::Vector3d& rotation_vector);

/// A rotation vector and its inverse spin map, which cost less if they are computed together.
struct LogarithmWithMap {
    Eigen::Vector3d rotation_vector;   ///< length at most pi
    Eigen::Matrix3d inverse_spin_map;  ///< maps a spin to the change of the rotation vector
};
/// The rotation vector of a rotation, and its inverse spin map.
LogarithmWithMap logarithm_with_map(const Eigen::Quaterniond& rotation);

/// The derivative with respect to v of spin_map(v)^T a, for a fixed a.
Eigen::Matrix3d spin_map_derivative(const Eigen::Vector3d& rotation_vector, const Eigen::Vector3d& a);

}  // namespace fretwork::geometry
