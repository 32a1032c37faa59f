// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/control.hpp>
#include <fretwork/tiling/dual/dual.hpp>
#include <fretwork/tiling/remeshing/size_field.hpp>

#include <cstddef>
#include <vector>

namespace fretwork::tiling::detail {

/// Make the cells as regular as they can be together: again and again, every cell wants its vertices on the
/// regular polygon nearest to it, and every vertex goes to the mean of what its cells want. Cells that are
/// far from regular pull harder and harder. Vertices of the rim slide along the outline, never past each
/// other; its corners stay. Convex cells stay convex at vertices that divide sides.
void regularize(Dual& dual, const Rim& rim, int iterations, const Work& work);

/// The same, while each side pulls at its ends, too, towards its wanted length: sides at the rim, which the
/// outline cuts, become as long as the others where angles allow.
void even_out(Dual& dual, const Rim& rim, const SizeField& field, int iterations, const Work& work);

/// Make one cell of neighbours where cells are wanted smaller, as long as that gives convex cells without
/// sharp angles whose sides are at most 1.5 times the largest wanted side. So a narrow band gets few long
/// cells. Points of the rim between two merged cells are removed if the outline is nearly straight there.
void merge_small_cells(Dual& dual, const SizeField& field, const base::Control& control);

/// Make one vertex of the ends of sides that are much shorter than the tiles' sides there, or shorter than
/// the smallest side allowed (metres), where the tiles keep three sides and the rim stays a simple curve.
/// Returns how many.
int collapse_short_sides(Dual& dual, const SizeField& field, double smallest_side,
                         const base::Control& control);

/// The tilings without one cell: without its area where it is the end of a limb, so small that its place may
/// stay uncovered (at most `most_area`, m2); and united with each neighbour with which it makes a convex
/// cell. None of them is compared with the outline. Throws base::Stopped.
std::vector<Dual> without_cell(const Dual& dual, std::size_t cell, double most_area,
                               const base::Control& control);

}  // namespace fretwork::tiling::detail
