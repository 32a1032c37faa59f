// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/geometry/box.hpp>
#include <fretwork/geometry/polygon.hpp>

#include <span>
#include <vector>

namespace fretwork::fabrication {

/// A corner of a contour, and the shape of the contour to the next corner.
struct ContourPoint {
    geometry::Point2 place;  ///< m
    /// The shape up to the next point: the tangent of a quarter of the angle of an arc, counterclockwise
    /// positive; 0: a straight line. DXF defines the bulge in the same way.
    double bulge = 0.0;
};

/// A closed curve of straight lines and circular arcs. The last point is joined to the first.
using Contour = std::vector<ContourPoint>;

/// The circle of an arc.
struct Arc {
    geometry::Point2 center;  ///< m
    double radius = 0.0;      ///< m
    double sweep = 0.0;       ///< angle of the arc, rad, counterclockwise positive
};
/// The arc from a point of a contour to the next point `to`. Pre: the bulge of `from` is not zero.
Arc arc_between(const ContourPoint& from, const geometry::Point2& to);

/// The area inside a contour, m2, exact with arcs; negative for a clockwise contour.
double signed_area(const Contour& contour);
/// The length of a contour, m, exact with arcs.
double length(const Contour& contour);

/// The contour with chords instead of arcs. No chord is farther than `tolerance` (m) from its arc.
geometry::Polygon flattened(const Contour& contour, double tolerance);

/// A counterclockwise circle, as two arcs. `radius` is in m.
Contour circle(const geometry::Point2& center, double radius);
/// A contour in the opposite direction.
Contour reversed(const Contour& contour);
/// A polygon as a contour of straight lines.
Contour straight(const geometry::Polygon& polygon);

/// The smallest box around a contour, arcs included. Pre: the contour is not empty.
geometry::Box box_of(const Contour& contour);

}  // namespace fretwork::fabrication
