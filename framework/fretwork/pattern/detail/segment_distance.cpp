// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/pattern/detail/segment_distance.hpp>

#include <CGAL/intersections.h>

#include <algorithm>
#include <cmath>

namespace fretwork::pattern::detail {
namespace {

/// Distances between segments in the metric of the hexagon, from affine coordinates of the base triangle, in
/// any number type.
template <class Number>
struct Segments {
    using Vector = std::array<Number, 2>;

    static Number dot(const Vector& a, const Vector& b) {
        return a[0] * b[0] + a[1] * b[1] + (a[0] * b[1] + a[1] * b[0]) / Number(2);
    }
    static Vector minus(const Vector& a, const Vector& b) { return {a[0] - b[0], a[1] - b[1]}; }

    static Number square_from_point(const Vector& point, const std::array<Vector, 2>& segment) {
        const Vector along = minus(segment[1], segment[0]);
        const Vector away = minus(point, segment[0]);
        const Number share = std::clamp<Number>(dot(away, along) / dot(along, along), Number(0), Number(1));
        const Vector rest{away[0] - share * along[0], away[1] - share * along[1]};
        return dot(rest, rest);
    }
    /// The squared distance of two segments that do not cross; it is the distance of an end of one segment
    /// from the other segment.
    static Number square_between_ends(const std::array<Vector, 2>& left, const std::array<Vector, 2>& right) {
        return std::min({square_from_point(left[0], right), square_from_point(left[1], right),
                         square_from_point(right[0], left), square_from_point(right[1], left)});
    }
};

std::array<std::array<ExactNumber, 2>, 2> exact_segment(const PlacedEdge& edge) {
    return {{{edge.points[0].x(), edge.points[0].y()}, {edge.points[1].x(), edge.points[1].y()}}};
}

std::array<std::array<double, 2>, 2> rounded_segment(const PlacedEdge& edge) {
    const auto rounded = [](const ExactNumber& number) { return CGAL::to_double(number); };
    return {{{rounded(edge.points[0].x()), rounded(edge.points[0].y())},
             {rounded(edge.points[1].x()), rounded(edge.points[1].y())}}};
}

bool cross(const PlacedEdge& left, const PlacedEdge& right) {
    return CGAL::do_intersect(ExactKernel::Segment_2(left.points[0], left.points[1]),
                              ExactKernel::Segment_2(right.points[0], right.points[1]));
}

}  // namespace

bool DistanceLimit::exceeds_distance(const PlacedEdge& left, const PlacedEdge& right) const {
    // Coordinates are below 2, and a rounded share moves the nearest point by less than the edge's length. So
    // the error of this distance is far below the margin, also for very short edges.
    constexpr double kMargin = 1e-6;
    const double rounded =
        std::sqrt(Segments<double>::square_between_ends(rounded_segment(left), rounded_segment(right)));
    if (rounded < distance_ - kMargin) return true;
    if (cross(left, right)) return distance_ > 0.0;
    if (rounded > distance_ + kMargin) return false;
    const ExactNumber limit(distance_);
    return Segments<ExactNumber>::square_between_ends(exact_segment(left), exact_segment(right)) <
           limit * limit;
}

}  // namespace fretwork::pattern::detail
