// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/outlines/outline.hpp>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

/// One reader for each kind of outline file.
namespace fretwork::outlines::detail {

/// The largest distance of a polygon from its curve, m; small drawings have a smaller one.
inline constexpr double kFlatteningTolerance = 2e-5;
/// The distance, as a share of the flattening tolerance, below which two points of a curve are one point.
inline constexpr double kClosingShare = 0.05;
/// The extent of a drawing, as a multiple of the flattening tolerance, below which the drawing is small.
inline constexpr double kDetail = 25'000;
/// The least flattening tolerance, m, that of a drawing smaller than an atom: grids need cells with a width.
inline constexpr double kLeastTolerance = 1e-15;

/// The flattening tolerance of a drawing with this extent, m, above zero. It is kFlatteningTolerance for
/// drawings that are not small, and for extent 0.
inline double flattening_tolerance(double extent) {
    const bool is_small = extent > 0 && extent < kDetail * kFlatteningTolerance;
    return is_small ? std::max(extent / kDetail, kLeastTolerance) : kFlatteningTolerance;
}

/// The largest number of pairs of sides whose boxes meet, which take seconds to test: a hundred neighbours
/// for each of hundreds of thousands of sides.
inline constexpr std::size_t kMostNear = 20'000'000;

/// The readers throw InputError or GeometryError with file and place.
OutlineFile read_svg_outlines(const std::filesystem::path& path);
OutlineFile read_dxf_outlines(const std::filesystem::path& path);

/// A closed curve of a mesh, in metres, and its place in the mesh.
struct Loop {
    geometry::Polygon points;
    std::string place;  ///< such as "the rim at vertex 12"
};

std::vector<Loop> read_obj_loops(const std::filesystem::path& path);
std::vector<Loop> read_ply_loops(const std::filesystem::path& path);
std::vector<Loop> read_off_loops(const std::filesystem::path& path);

/// The outline with the loop of the largest area as its boundary, and all others as holes. Throws
/// GeometryError that names the loops if they are not an outline, such as two loops side by side. Throws
/// GeometryError, too, if there is no loop.
Outline outline_of(std::vector<Loop> loops);

}  // namespace fretwork::outlines::detail
