// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/control.hpp>
#include <fretwork/tiling/dual/dual.hpp>

#include <vector>

namespace fretwork::tiling::detail {

/// The sides that belong to one cell only, as closed lines of vertices.
struct DualRim {
    std::vector<std::vector<DualVertexIndex>> lines;
    /// Vertices at which the rim touches itself, and ends of lines that are not closed. Also one end of each
    /// side that more than two cells have, or that two cells have in the same direction.
    std::vector<DualVertexIndex> knots;
};

/// The rim of a dual. Throws base::Stopped.
DualRim rim_of(const Dual& dual, const base::Control& control);

/// The lines of the rim as polygons; the outer line comes first. Pre: there is at least one line.
std::vector<geometry::Polygon> loops_of(const Dual& dual, const DualRim& rim);

/// The number of pieces of a tiling, and a cell of the smallest piece. A piece is a set of cells connected by
/// sides.
struct Pieces {
    int count = 0;
    std::size_t cell_of_smallest = 0;
};
/// Throws base::Stopped.
Pieces pieces_of(const Dual& dual, const base::Control& control);

}  // namespace fretwork::tiling::detail
