// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/tiling/outline.hpp>

#include <filesystem>
#include <string>
#include <vector>

/// One reader for each kind of outline file: closed curves out of it, in metres.
namespace fretwork::tiling::detail {

/// Curves become polygons that stay within this distance of them, metres.
inline constexpr double kFlatteningTolerance = 2e-5;
/// Ends of a curve nearer than this to each other are one point, metres.
inline constexpr double kClosingTolerance = 1e-6;

/// A closed polygon of a file, and where it stands there.
struct Loop {
    pattern::Polygon points;
    std::string place;  ///< such as "path 'rim'" or "line 12"
};

std::vector<Loop> read_svg_loops(const std::filesystem::path& path);
std::vector<Loop> read_dxf_loops(const std::filesystem::path& path);
std::vector<Loop> read_obj_loops(const std::filesystem::path& path);
std::vector<Loop> read_ply_loops(const std::filesystem::path& path);
std::vector<Loop> read_off_loops(const std::filesystem::path& path);

/// The outermost loop is the boundary, those inside it are holes. Throws GeometryError that names the loops
/// if two of them lie side by side, or one lies in a hole.
Outline outline_of(std::vector<Loop> loops);

}  // namespace fretwork::tiling::detail
