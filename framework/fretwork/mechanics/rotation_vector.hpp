// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/element.hpp>

#include <Eigen/Geometry>

#include <vector>

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

/// The state of a node from a row of its displacement and rotation vector.
inline NodeState node_state(const Eigen::Matrix<double, 1, kDofsPerNode>& row) {
    return {row.head<3>().transpose(), rotation_of(row.tail<3>().transpose())};
}

/// The states of nodes, one row each.
inline std::vector<NodeState> node_states(const NodeValues& rows) {
    std::vector<NodeState> states;
    states.reserve(static_cast<std::size_t>(rows.rows()));
    for (Eigen::Index i = 0; i < rows.rows(); ++i) states.push_back(node_state(rows.row(i)));
    return states;
}

}  // namespace fretwork::mechanics
