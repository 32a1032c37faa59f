// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/outlines/outline.hpp>

#include <optional>
#include <vector>

/// From closed curves to what they fill: parts with holes. Crossings are found exactly.
namespace fretwork::outlines::detail {

enum class FillRule { Nonzero, Evenodd };

/// Slits and needles narrower than this share of the tolerance are closed and cut off: where lines nearly
/// meet there are such. Less than the width to which points that touch are opened.
inline constexpr double kWeldShare = 0.25;

/// Closed polygons that are filled together, in metres. They may cross themselves and each other.
struct FilledShape {
    std::vector<geometry::Polygon> loops;
    FillRule rule = FillRule::Nonzero;
    std::optional<std::size_t> clip{};  ///< of the picture: only what lies within it is filled
};

/// The area that lies in one of the shapes, and in the outer clip.
struct Clip {
    std::vector<FilledShape> shapes;
    std::optional<std::size_t> outer{};
};

struct Picture {
    std::vector<FilledShape> shapes;
    std::vector<Clip> clips;
};

/// The union of shapes. Parts narrower than the tolerance are left out: where lines nearly meet, there are
/// such.
struct Region {
    std::vector<Outline> parts;          ///< the largest first
    int touches = 0;                     ///< points where a part touched itself, now opened by the tolerance
    int slits = 0;                       ///< holes narrower than the tolerance, now filled
    int doubled = 0;                     ///< shapes that are drawn over an equal one
    bool is_welded = false;              ///< slits were closed, or needles cut off: kWeldShare
    std::optional<std::size_t> cover{};  ///< the shape that covers all others, if one does
};

/// The union of what a picture fills. Nothing of it is narrower than `tolerance` (metres) as a whole.
Region filled_region(const Picture& picture, double tolerance);

/// The union of closed curves, where what lies inside of one curve is a hole, what lies inside of that is
/// filled again, and so on. Throws GeometryError if too many lie in one another.
Region nested_region(const std::vector<geometry::Polygon>& curves, double tolerance);

/// The outer contours of what lines enclose: a room divided by a line is one contour. Ends that hang loose,
/// and lines with the same face on both sides, enclose nothing.
struct Contours {
    std::vector<geometry::Polygon> closed;
    std::vector<std::size_t> open;  ///< the lines that enclose nothing
};
Contours contours_of(const std::vector<geometry::Polygon>& lines);

}  // namespace fretwork::outlines::detail
