// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/element.hpp>
#include <fretwork/mechanics/solution.hpp>

#include <Eigen/Geometry>

#include <vector>

namespace fretwork::simulation::detail {

inline Eigen::Quaterniond rotation_of(const Eigen::Vector3d& rotation_vector) {
    const double angle = rotation_vector.norm();
    if (angle == 0.0) return Eigen::Quaterniond::Identity();
    return Eigen::Quaterniond(Eigen::AngleAxisd(angle, rotation_vector / angle));
}

/// At most pi long.
inline Eigen::Vector3d rotation_vector(const Eigen::Quaterniond& rotation) {
    const Eigen::AngleAxisd turn(rotation.w() < 0.0 ? Eigen::Quaterniond(-rotation.coeffs()) : rotation);
    return turn.angle() * turn.axis();
}

/// The states of nodes from displacements and rotation vectors, one row each.
inline std::vector<mechanics::NodeState> node_states(const mechanics::NodeValues& rows) {
    std::vector<mechanics::NodeState> states(static_cast<std::size_t>(rows.rows()));
    for (Eigen::Index i = 0; i < rows.rows(); ++i) {
        states[static_cast<std::size_t>(i)] = {rows.row(i).head<3>().transpose(),
                                               rotation_of(rows.row(i).tail<3>().transpose())};
    }
    return states;
}

}  // namespace fretwork::simulation::detail
