// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/geometry/rotation.hpp>
#include <fretwork/mechanics/element.hpp>

#include <Eigen/Geometry>

#include <vector>

namespace fretwork::mechanics {

/// The state of a node from a row with its displacement and rotation vector.
inline NodeState node_state(const Eigen::Matrix<double, 1, kDofsPerNode>& row) {
    return {row.head<3>().transpose(), geometry::exponential(row.tail<3>().transpose())};
}

/// The states of nodes from rows with their displacements and rotation vectors.
inline std::vector<NodeState> node_states(const NodeValues& rows) {
    std::vector<NodeState> states;
    states.reserve(rows.rows());
    for (Eigen::Index i = 0; i < rows.rows(); ++i) states.push_back(node_state(rows.row(i)));
    return states;
}

}  // namespace fretwork::mechanics
