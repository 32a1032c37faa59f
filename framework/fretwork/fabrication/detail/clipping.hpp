// SPDX-License-Identifier: GPL-3.0-or-later
// Booleans of polygons on a grid of nanometres, with the arcs of known circles found again in what they give.
#pragma once

#include <fretwork/fabrication/contour.hpp>
#include <fretwork/fabrication/detail/patches.hpp>

#include <span>
#include <vector>

namespace fretwork::fabrication::detail {

/// What is left of `whole` without `parts`: its boundary, counterclockwise, and clockwise those of what was
/// taken from its inside. Walks may touch themselves. Exact but for the grid, and less than a square
/// micrometre is left out.
std::vector<pattern::Polygon> difference(const pattern::Polygon& whole,
                                         std::span<const pattern::Polygon> parts);

/// The union of polygons, any of which may be clockwise: outer boundaries counterclockwise, openings
/// clockwise.
std::vector<pattern::Polygon> united(std::span<const pattern::Polygon> polygons);

/// The union of polygons with openings (as united() gives them).
std::vector<pattern::Polygon> merged(std::span<const pattern::Polygon> left,
                                     std::span<const pattern::Polygon> right);

/// Polygons with openings less others.
std::vector<pattern::Polygon> without(std::span<const pattern::Polygon> whole,
                                      std::span<const pattern::Polygon> parts);

/// Put arcs in the place of chords of the given circles.
Contour with_arcs(const pattern::Polygon& polygon, std::span<const Disc> discs);

}  // namespace fretwork::fabrication::detail
