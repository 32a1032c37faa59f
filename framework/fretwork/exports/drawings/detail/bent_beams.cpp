// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/exports/drawings/detail/bent_beams.hpp>
#include <fretwork/mechanics/discretization.hpp>
#include <fretwork/mechanics/linear_solver.hpp>

namespace fretwork::exports::detail {

LineSet bent_beams(mechanics::Frame beams, const mechanics::NodeValues& moved) {
    beams.supports.clear();
    beams.loads.clear();
    beams.prescribed.clear();
    for (Eigen::Index node = 0; node < moved.rows(); ++node)
        for (int dof = 0; dof < mechanics::kDofsPerNode; ++dof)
            beams.prescribed.push_back(
                {mechanics::NodeIndex(node), static_cast<mechanics::Dof>(dof), moved(node, dof)});
    LineSet lines = frame_lines(beams);
    lines.displacements = mechanics::solve_linear(mechanics::assemble(beams)).displacements;
    return lines;
}

}  // namespace fretwork::exports::detail
