// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/control.hpp>
#include <fretwork/geometry/polygon.hpp>

#include <optional>
#include <string>
#include <vector>

namespace fretwork::outlines {

/// The fault of loops (the boundary, then the holes) that are no outline, decided exactly: a point that is
/// not finite, a side without length, two sides that touch or cross, a hole outside the boundary or inside
/// another. Throws base::Stopped.
std::optional<std::string> outline_flaw(const std::vector<geometry::Polygon>& loops,
                                        const base::Control& control);

/// Where loops cross or touch themselves or each other, decided exactly: the middles of such sides. If there
/// are none, the first point of each hole that lies outside the boundary or inside another. Throws
/// base::Stopped.
std::vector<geometry::Point2> places_of_crossings(const std::vector<geometry::Polygon>& loops,
                                                  const base::Control& control);

}  // namespace fretwork::outlines
