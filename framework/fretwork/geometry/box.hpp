// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/geometry/polygon.hpp>

#include <span>

namespace fretwork::geometry {

/// A rectangle with sides parallel to the axes, in metres.
struct Box {
    double xmin = 0.0;  ///< m
    double ymin = 0.0;  ///< m
    double xmax = 0.0;  ///< m
    double ymax = 0.0;  ///< m
    /// The size of the box along x, m.
    [[nodiscard]] double width() const { return xmax - xmin; }
    /// The size of the box along y, m.
    [[nodiscard]] double height() const { return ymax - ymin; }
    /// The distance of two opposite corners, m.
    [[nodiscard]] double diagonal() const;
    /// The middle of the box.
    [[nodiscard]] Point2 middle() const { return {0.5 * (xmin + xmax), 0.5 * (ymin + ymax)}; }
    /// True if the boxes have a point in common.
    [[nodiscard]] bool meets(const Box& other) const {
        return xmin <= other.xmax && other.xmin <= xmax && ymin <= other.ymax && other.ymin <= ymax;
    }
};
/// The smallest box around the points. Pre: there is at least one point.
Box box_of(std::span<const Point2> points);
/// The smallest box around a box and a point.
Box united(const Box& box, Point2 point);
/// The smallest box around two boxes.
Box united(const Box& left, const Box& right);
/// The box enlarged by `margin` (m) on every side.
Box grown(const Box& box, double margin);

}  // namespace fretwork::geometry
