// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/pattern/polygon.hpp>

#include <filesystem>
#include <vector>

namespace fretwork::tiling {

/// A flat shape: a simple boundary (counterclockwise) with holes (clockwise) inside it that neither touch nor
/// overlap.
struct Outline {
    pattern::Polygon boundary;  ///< metres
    std::vector<pattern::Polygon> holes;
};

/// Check and orient an outline. Throws GeometryError that names the two sides which cross, or the hole that
/// lies outside.
Outline make_outline(pattern::Polygon boundary, std::vector<pattern::Polygon> holes);

/// Read an outline: SVG (paths, polygons, rectangles, circles, ellipses; physical units or mm), DXF,
/// OBJ/PLY/OFF (flat), JSON polygons with holes. The ending tells which. Throws InputError or GeometryError
/// with file and place.
Outline read_outline(const std::filesystem::path& path);

}  // namespace fretwork::tiling
