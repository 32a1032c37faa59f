// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/control.hpp>
#include <fretwork/geometry/polygon.hpp>

#include <optional>
#include <string>
#include <vector>

namespace fretwork::outlines {

/// Find, by exact tests, why loops (the boundary, then the holes) are not an outline: a loop of less than
/// three points, a point that is not finite, a side of length zero, two sides that touch or cross, a hole
/// outside the boundary or inside another hole. Nothing if the loops are an outline. Throws base::Stopped,
/// and GeometryError if sides come near each other too often to test all pairs.
std::optional<std::string> outline_flaw(const std::vector<geometry::Polygon>& loops,
                                        const base::Control& control);

/// The middles of all sides that cross or touch another side, by exact tests. If there are none, the first
/// point of each hole that lies outside the boundary or inside another hole. Throws as outline_flaw().
std::vector<geometry::Point2> places_of_crossings(const std::vector<geometry::Polygon>& loops,
                                                  const base::Control& control);

}  // namespace fretwork::outlines
