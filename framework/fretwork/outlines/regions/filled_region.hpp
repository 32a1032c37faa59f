// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/outlines/outline.hpp>

#include <optional>
#include <vector>

/// Regions filled by closed curves, as parts with holes. Crossings are found exactly.
namespace fretwork::outlines::detail {

enum class FillRule { Nonzero, Evenodd };

/// Slits are closed and needles are cut off below this width, as a share of the tolerance. They occur where
/// lines nearly meet. Touching points are opened by more than this width.
inline constexpr double kWeldShare = 0.25;

/// Closed polygons that are filled together, in metres. The polygons may cross themselves and each other.
struct FilledShape {
    std::vector<geometry::Polygon> loops;
    FillRule rule = FillRule::Nonzero;
    /// Index of a clip of the picture; only the area within that clip is filled.
    std::optional<std::size_t> clip{};
};

/// The area inside any of the shapes and inside the outer clip.
struct Clip {
    std::vector<FilledShape> shapes;
    std::optional<std::size_t> outer{};
};

struct Picture {
    std::vector<FilledShape> shapes;
    std::vector<Clip> clips;
};

/// The union of shapes. Parts narrower than the tolerance are left out; such parts occur where lines nearly
/// meet.
struct Region {
    std::vector<Outline> parts;  ///< the largest first
    /// Number of points where a part touched itself; each point is opened by the tolerance.
    int touches = 0;
    /// Number of holes narrower than the tolerance; each such hole is filled.
    int slits = 0;
    int doubled = 0;                     ///< number of shapes that are drawn over an equal shape
    bool is_welded = false;              ///< true if slits were closed or needles cut off; see kWeldShare
    std::optional<std::size_t> cover{};  ///< index of the shape that covers all others, if there is one
};

/// The union of the areas that a picture fills. Each part of the union is at least `tolerance` (m) wide at
/// its widest place. Throws GeometryError as make_line_map() and region_of_map().
Region filled_region(const Picture& picture, double tolerance);

/// The region that nested closed curves fill: a curve inside another bounds a hole, a curve inside that hole
/// bounds a filled area again, and so on. `tolerance` is as for filled_region(). Throws GeometryError as
/// filled_region(), and if curves are nested too deeply.
Region nested_region(const std::vector<geometry::Polygon>& curves, double tolerance);

/// The outer contours of the areas that lines enclose. An area that a line divides has one contour. Loose
/// ends, and lines with the same face on both sides, enclose nothing.
struct Contours {
    std::vector<geometry::Polygon> closed;
    std::vector<std::size_t> open;  ///< indices of the lines that enclose nothing
};
/// Throws GeometryError as make_line_map().
Contours contours_of(const std::vector<geometry::Polygon>& lines);

}  // namespace fretwork::outlines::detail
