// SPDX-License-Identifier: GPL-3.0-or-later
// Boolean operations on polygons, on a grid of nanometres. with_arcs() finds the arcs of known circles in the
// results.
#pragma once

#include <fretwork/fabrication/contour.hpp>
#include <fretwork/fabrication/detail/patches.hpp>

#include <span>
#include <vector>

namespace fretwork::fabrication::detail {

/// The difference of `whole` and `parts`: outer boundaries counterclockwise, boundaries of removed insides
/// clockwise. `whole` and `parts` may touch themselves. The result is exact up to 20 nm, because corners so
/// near to each other are merged. Areas below a square micrometre are left out.
std::vector<geometry::Polygon> difference(const geometry::Polygon& whole,
                                          std::span<const geometry::Polygon> parts);

/// The union of polygons, any of which may be clockwise: outer boundaries counterclockwise, openings
/// clockwise.
std::vector<geometry::Polygon> united(std::span<const geometry::Polygon> polygons);

/// The union of polygons with openings (as united() gives them).
std::vector<geometry::Polygon> merged(std::span<const geometry::Polygon> left,
                                      std::span<const geometry::Polygon> right);

/// The difference of polygons with openings: `whole` without `parts`.
std::vector<geometry::Polygon> without(std::span<const geometry::Polygon> whole,
                                       std::span<const geometry::Polygon> parts);

/// The least width of bars, m. The corners of their round ends then lie off the line between their neighbours
/// by twice the distance at which corners are removed. Outlines of narrower bars come out wrong, with
/// openings larger than their regions.
double least_width();

/// Put arcs in the place of chords of the given circles.
Contour with_arcs(const geometry::Polygon& polygon, std::span<const Disc> discs);

}  // namespace fretwork::fabrication::detail
