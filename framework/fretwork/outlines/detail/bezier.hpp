// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/geometry/polygon.hpp>

#include <array>
#include <vector>

namespace fretwork::outlines::detail {

/// x' = a x + c y + e, y' = b x + d y + f.
struct Affine {
    double a = 1.0, b = 0.0, c = 0.0, d = 1.0, e = 0.0, f = 0.0;
    [[nodiscard]] geometry::Point2 operator()(geometry::Point2 p) const {
        return {a * p.x + c * p.y + e, b * p.x + d * p.y + f};
    }
    /// The map that applies `inner` first, and then this map.
    [[nodiscard]] Affine after(const Affine& inner) const {
        return {a * inner.a + c * inner.b, b * inner.a + d * inner.b,     a * inner.c + c * inner.d,
                b * inner.c + d * inner.d, a * inner.e + c * inner.f + e, b * inner.e + d * inner.f + f};
    }
};

/// A cubic Bezier curve, given by its control points. The control points of a straight piece lie on a line.
using Bezier = std::array<geometry::Point2, 4>;

/// A chain of curves; each curve begins at the end of the curve before it.
struct Subpath {
    std::vector<Bezier> pieces;
    /// True if the file closes the subpath; the ends of an open subpath may still meet.
    bool is_closed = false;
};

Bezier straight(geometry::Point2 from, geometry::Point2 to);

/// An elliptic arc: the points center + axes[0] cos t + axes[1] sin t, for t from `start` to `start` +
/// `sweep`. beziers_of() cuts the arc into pieces of at most 30 degrees, with errors of less than a millionth
/// of the radius; it throws GeometryError if the sweep is not finite.
struct Arc {
    geometry::Point2 center;
    std::array<geometry::Point2, 2> axes;
    double start = 0.0;  ///< rad
    double sweep = 0.0;  ///< rad, either sign
};
std::vector<Bezier> beziers_of(const Arc& arc);

/// The map to metres, and the largest error of a polygon.
struct Flattening {
    Affine to_metres{};
    double tolerance;  ///< metres
};
/// The polygon of a subpath. Throws GeometryError, with the place, if it would have far more points than an
/// outline can use.
geometry::Polygon flatten(const Subpath& subpath, const Flattening& how);

}  // namespace fretwork::outlines::detail
