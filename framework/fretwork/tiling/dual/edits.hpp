// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/control.hpp>
#include <fretwork/tiling/dual/dual.hpp>
#include <fretwork/tiling/remeshing/size_field.hpp>

#include <cstddef>
#include <vector>

namespace fretwork::tiling::detail {

/// Make all cells as regular as possible, by iteration. In each iteration, every cell proposes the nearest
/// regular polygon, and every vertex moves to the weighted mean of its cells' proposals. The weight of cells
/// that are far from regular grows. Vertices on the rim slide along the outline and keep their order; the
/// outline's corners stay. Convex cells stay convex at vertices that divide sides. Throws base::Stopped.
void regularize(Dual& dual, const Rim& rim, int iterations, const SharedTask& task);

/// Regularize, and in each iteration also move the ends of each side towards its wanted length. As far as
/// angles allow, the sides cut by the outline become as long as the others. Throws base::Stopped.
void even_out(Dual& dual, const Rim& rim, const SizeField& field, int iterations, const SharedTask& task);

/// Merge neighbouring cells where the wanted side is reduced, as long as the merged cells are convex, have no
/// sharp angles, and have sides of at most 1.5 times the largest wanted side. A narrow band thus gets few
/// long cells. A point of the rim between two merged cells is removed if the outline is nearly straight at
/// the point. Throws base::Stopped.
void merge_small_cells(Dual& dual, const SizeField& field, const base::Control& control);

/// Collapse sides that are much shorter than the other sides of their tiles, or shorter than `smallest_side`
/// (m). A side is collapsed only if the tiles keep at least three sides and the rim stays a simple curve.
/// Returns the number of collapsed sides. Throws base::Stopped.
int collapse_short_sides(Dual& dual, const SizeField& field, double smallest_side,
                         const base::Control& control);

/// The tilings that result from removing one cell. If the cell is the end of a limb and its area is at most
/// `most_area` (m2), the first tiling leaves this area uncovered. Each other tiling unites the cell with one
/// neighbour, if the union is convex. The tilings are not yet compared with the outline. Throws
/// base::Stopped.
std::vector<Dual> without_cell(const Dual& dual, std::size_t cell, double most_area,
                               const base::Control& control);

}  // namespace fretwork::tiling::detail
