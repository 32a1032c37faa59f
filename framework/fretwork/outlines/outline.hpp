// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/geometry/polygon.hpp>

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace fretwork::outlines {

/// A flat shape: a simple boundary (counterclockwise) with holes (clockwise) inside it that neither touch nor
/// overlap.
struct Outline {
    geometry::Polygon boundary;  ///< metres
    std::vector<geometry::Polygon> holes;
};

/// Check and orient an outline. Throws GeometryError that names the two sides which cross, or the hole that
/// lies outside.
Outline make_outline(geometry::Polygon boundary, std::vector<geometry::Polygon> holes);

/// The area of an outline, its holes left out.
double area_of(const Outline& outline);

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

/// A file's outlines, and the changes made to read them.
struct OutlineFile {
    std::vector<Outline> parts;  ///< the largest first
    /// Each in a few words for a person, and bounded in length: "2 gaps of at most 0.02 mm closed".
    std::vector<std::string> remarks;
};

/// Read outlines: SVG (what a browser would fill), DXF (closed curves of the model space), OBJ/PLY/OFF (flat,
/// one part), JSON (one part). The file's ending decides. Lengths are metres, x to the right, y upwards; the
/// origin of an SVG is the lower left of its viewBox, the others keep theirs. Throws InputError or
/// GeometryError with file and place.
OutlineFile read_outline_file(const std::filesystem::path& path);
/// The largest part of a file.
Outline read_outline(const std::filesystem::path& path);

/// Take parts of a file: "largest", "all", or a number from 1, the largest first. A remark says what was
/// taken if something was not. Throws InputError that says what there is.
OutlineFile take_parts(OutlineFile file, std::string_view which);

/// All parts of a file by one factor, so that together they are `width` wide, metres.
OutlineFile scaled_to_width(OutlineFile file, double width);

/// Width and height of some outlines together, for people: "284 x 190 mm".
std::string size_text(const std::vector<Outline>& parts);

}  // namespace fretwork::outlines
