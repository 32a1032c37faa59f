// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/element.hpp>
#include <fretwork/mechanics/rotation_vector.hpp>
#include <fretwork/mechanics/solution.hpp>

#include <vector>

namespace fretwork::simulation::detail {

/// The states of nodes from displacements and rotation vectors, one row each.
inline std::vector<mechanics::NodeState> node_states(const mechanics::NodeValues& rows) {
    std::vector<mechanics::NodeState> states(static_cast<std::size_t>(rows.rows()));
    for (Eigen::Index i = 0; i < rows.rows(); ++i) {
        states[static_cast<std::size_t>(i)] = {rows.row(i).head<3>().transpose(),
                                               mechanics::rotation_of(rows.row(i).tail<3>().transpose())};
    }
    return states;
}

}  // namespace fretwork::simulation::detail
