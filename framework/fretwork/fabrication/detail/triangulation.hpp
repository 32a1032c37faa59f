// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/geometry/polygon.hpp>

#include <array>
#include <span>
#include <vector>

namespace fretwork::fabrication::detail {

/// The inside of closed lines as counterclockwise triangles without further corners. The corners are numbered
/// line by line. Throws GeometryError that names the place where lines cross or touch.
std::vector<std::array<int, 3>> triangulated(std::span<const geometry::Polygon> lines);

}  // namespace fretwork::fabrication::detail
