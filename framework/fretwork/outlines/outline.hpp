// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/geometry/polygon.hpp>

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace fretwork::outlines {

/// A flat shape: a simple boundary (counterclockwise), and holes (clockwise) inside it that neither touch nor
/// overlap.
struct Outline {
    geometry::Polygon boundary;            ///< metres
    std::vector<geometry::Polygon> holes;  ///< metres; clockwise, inside the boundary, apart
    friend bool operator==(const Outline&, const Outline&) = default;
};

/// Check and orient an outline. Throws GeometryError that names the first flaw, such as two sides that cross
/// (see outline_flaw()), or a point beyond the limits of lengths.
Outline make_outline(geometry::Polygon boundary, std::vector<geometry::Polygon> holes);

/// The area of an outline without its holes, m2.
double area_of(const Outline& outline);

/// Parse an outline in JSON, in metres:
///
///     { "format": "fretwork/outline/1", "boundary": [[0, 0], [0.4, 0], [0, 0.3]], "holes": [] }
///
/// `holes` may be left out. Throws InputError or GeometryError with source and place.
///
/// @param source  the name of the text in messages
Outline parse_outline(std::string_view text, const std::string& source);
/// The outline as JSON; parse_outline gives an equal outline. Throws NumericalError if a coordinate is not
/// finite.
std::string outline_text(const Outline& outline);
/// Write an outline as JSON, atomically. Throws as outline_text(), and IoError if writing fails; the file is
/// then as it was.
void write_outline(const Outline& outline, const std::filesystem::path& path);

/// The outlines of a file, and remarks about changes made by the reader.
struct OutlineFile {
    std::vector<Outline> parts;  ///< the largest first
    /// One short remark for each kind of change: "2 gaps of at most 0.02 mm closed".
    std::vector<std::string> remarks;
};

/// Read outlines from SVG (the areas that a browser would fill or, if there are none, the areas in closed
/// lines), DXF (the areas in closed lines of the model space), OBJ/PLY/OFF (flat, one part) or JSON (one
/// part). The file extension selects the format. Lengths are metres; x runs to the right, y upwards. The
/// origin of an SVG is the lower left corner of its viewBox; other files keep their origin. Throws InputError
/// or GeometryError with file and place.
OutlineFile read_outline_file(const std::filesystem::path& path);
/// The largest part of a file. Reads and throws as read_outline_file().
Outline read_outline(const std::filesystem::path& path);

/// Select parts of a file: "largest", "all", or a number; part 1 is the largest. If parts are left out, a
/// remark names the part that was taken. Throws InputError that lists the valid choices.
OutlineFile take_parts(OutlineFile file, std::string_view which);

/// Scale all parts of a file by one factor, so that the box around them is `width` metres wide. Throws
/// GeometryError if a part is no outline any more because of rounding. Pre: there is at least one part, and
/// `width` is above zero.
OutlineFile scaled_to_width(OutlineFile file, double width);

/// The width and height of the box around outlines: "284 x 190 mm". Pre: there is at least one part.
std::string size_text(const std::vector<Outline>& parts);

}  // namespace fretwork::outlines
