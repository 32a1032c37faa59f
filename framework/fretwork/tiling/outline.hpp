// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/pattern/polygon.hpp>

#include <filesystem>
#include <string>
#include <string_view>
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

/// Parse an outline in the project's own form, metres:
///
///     { "format": "fretwork/outline/1", "boundary": [[0, 0], [0.4, 0], [0, 0.3]], "holes": [] }
///
/// `holes` may be left out. Throws InputError or GeometryError with source and place.
///
/// @param source  what to call the text in messages
Outline parse_outline(std::string_view text, const std::string& source);
/// The outline as JSON; parse_outline gives an equal outline.
std::string outline_text(const Outline& outline);
/// Write an outline as JSON. Throws IoError; then the file is as it was.
void write_outline(const Outline& outline, const std::filesystem::path& path);

/// Read an outline: SVG (paths, polygons, rectangles, circles, ellipses; physical units or mm), DXF,
/// OBJ/PLY/OFF (flat), JSON polygons with holes. The ending tells which. Throws InputError or GeometryError
/// with file and place.
Outline read_outline(const std::filesystem::path& path);

}  // namespace fretwork::tiling
