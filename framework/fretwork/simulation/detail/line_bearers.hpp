// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/simulation/load_cases/load_case.hpp>

#include <vector>

namespace fretwork::simulation::detail {

/// An interface node, and the length of a line load that it stands for, m.
struct LineBearer {
    tiling::InterfaceIndex node;
    double length = 0.0;
};

/// The nodes that bear a line load (Amount::PerLength), with their lengths. Throws InputError if
/// the selection is neither a side nor two points, if no side of a tile lies along the side, if a point is
/// beyond the limits of lengths or not a number, or if both points are nearest to the same place of the rim
/// or to different closed lines of it.
std::vector<LineBearer> line_bearers(const Selection& where, const tiling::Tessellation& tessellation);

}  // namespace fretwork::simulation::detail
