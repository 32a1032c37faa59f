// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/pattern/polygon.hpp>

#include <span>
#include <vector>

namespace fretwork::fabrication {

/// A corner of a contour, and how the contour goes on to the next one.
struct ContourPoint {
    pattern::Point2 place;  ///< m
    /// Tangent of a quarter of the angle of the arc to the next point, counterclockwise positive; 0: a
    /// straight line. DXF has the same.
    double bulge = 0.0;
};

/// A closed curve of straight lines and circular arcs; the last point goes on to the first.
using Contour = std::vector<ContourPoint>;

/// The circle of an arc.
struct Arc {
    pattern::Point2 center;
    double radius = 0.0;  ///< m
    double sweep = 0.0;   ///< rad, counterclockwise positive
};
/// The arc from a point to the next one. Its bulge must not be zero.
Arc arc_between(const ContourPoint& from, const pattern::Point2& to);

/// The area inside, m2; negative for a clockwise contour. Exact, arcs included.
double signed_area(const Contour& contour);
/// m. Exact, arcs included.
double length(const Contour& contour);

/// The contour with arcs as chords that are off by at most `tolerance` (m).
pattern::Polygon flattened(const Contour& contour, double tolerance);

/// A full circle, counterclockwise, as two arcs.
Contour circle(const pattern::Point2& center, double radius);
/// The same curve in the other direction.
Contour reversed(const Contour& contour);
/// Straight lines between points.
Contour straight(const pattern::Polygon& polygon);

/// Part of the plane, m.
struct Box {
    double xmin = 0.0, ymin = 0.0, xmax = 0.0, ymax = 0.0;
    [[nodiscard]] double width() const { return xmax - xmin; }
    [[nodiscard]] double height() const { return ymax - ymin; }
    [[nodiscard]] bool meets(const Box& other) const {
        return xmin <= other.xmax && other.xmin <= xmax && ymin <= other.ymax && other.ymin <= ymax;
    }
};
/// The smallest box around some points.
Box box_of(std::span<const pattern::Point2> points);
/// The smallest box around a contour, arcs included.
Box box_of(const Contour& contour);
/// The smallest box around two.
Box united(const Box& left, const Box& right);
/// Wider by a margin on every side, m.
Box grown(const Box& box, double margin);

}  // namespace fretwork::fabrication
