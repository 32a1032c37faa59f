// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/results/solution.hpp>

namespace fretwork::simulation::detail {

/// The displacements of all nodes of an assembly: the reported ones, then the others.
inline mechanics::NodeValues all_rows(const mechanics::Solution& solution) {
    mechanics::NodeValues rows(solution.displacements.rows() + solution.inner_displacements.rows(),
                               mechanics::kDofsPerNode);
    rows << solution.displacements, solution.inner_displacements;
    return rows;
}

}  // namespace fretwork::simulation::detail
