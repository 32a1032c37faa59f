// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/outlines/outline.hpp>

#include <filesystem>
#include <string>
#include <vector>

/// One reader for each kind of outline file.
namespace fretwork::outlines::detail {

/// Curves become polygons that stay within this distance of them, metres; within less in small drawings.
inline constexpr double kFlatteningTolerance = 2e-5;
/// Points of a curve nearer than this share of that distance to each other are one point.
inline constexpr double kClosingShare = 0.05;
/// A drawing is small if its extent is below this many times the distance.
inline constexpr double kDetail = 25'000;

inline double flattening_tolerance(double extent) {
    return extent > 0 && extent < kDetail * kFlatteningTolerance ? extent / kDetail : kFlatteningTolerance;
}

OutlineFile read_svg_outlines(const std::filesystem::path& path);
OutlineFile read_dxf_outlines(const std::filesystem::path& path);

/// A closed curve of a mesh, in metres, and where it stands there.
struct Loop {
    geometry::Polygon points;
    std::string place;  ///< such as "the rim at vertex 12"
};

std::vector<Loop> read_obj_loops(const std::filesystem::path& path);
std::vector<Loop> read_ply_loops(const std::filesystem::path& path);
std::vector<Loop> read_off_loops(const std::filesystem::path& path);

/// The outermost loop is the boundary, those inside it are holes. Throws GeometryError that names the loops
/// if two of them lie side by side, or one lies in a hole.
Outline outline_of(std::vector<Loop> loops);

}  // namespace fretwork::outlines::detail
