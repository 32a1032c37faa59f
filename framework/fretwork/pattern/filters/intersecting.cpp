// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/pattern/detail/conflicts.hpp>
#include <fretwork/pattern/detail/exact_geometry.hpp>
#include <fretwork/pattern/filters/filters.hpp>

#include <CGAL/intersections.h>

namespace fretwork::pattern::filters {
namespace {

using detail::ConflictTable;
using detail::exact_point;
using detail::ExactKernel;
using detail::ExactPoint;

/// Two edges out of one node overlap if they leave it in the same direction.
bool leave_alike(const ExactPoint& shared, const ExactPoint& first, const ExactPoint& second) {
    return CGAL::collinear(shared, first, second) &&
           !CGAL::collinear_are_strictly_ordered_along_line(first, shared, second);
}

/// True if two edges meet at a point other than a common end.
bool intersect(const NodeLayout& layout, const Edge& left, const Edge& right) {
    const auto point = [&](LayoutNodeIndex node) { return exact_point(layout.nodes()[node]); };
    if (left.first == right.first)
        return leave_alike(point(left.first), point(left.second), point(right.second));
    if (left.first == right.second)
        return leave_alike(point(left.first), point(left.second), point(right.first));
    if (left.second == right.first)
        return leave_alike(point(left.second), point(left.first), point(right.second));
    if (left.second == right.second)
        return leave_alike(point(left.second), point(left.first), point(right.first));
    return CGAL::do_intersect(ExactKernel::Segment_2(point(left.first), point(left.second)),
                              ExactKernel::Segment_2(point(right.first), point(right.second)));
}

}  // namespace

// Two sectors share only the points of a radial side, and no candidate edge runs along the right one. So all
// crossings lie inside one base triangle.
Rule make_intersecting(const NodeLayout& layout, double, const FabricationScale&) {
    ConflictTable table(layout);
    const auto& edges = layout.candidate_edges();
    for (std::size_t e = 0; e < edges.size(); ++e) {
        for (std::size_t f = e + 1; f < edges.size(); ++f) {
            if (intersect(layout, edges[e], edges[f])) table.add(EdgeIndex(e), EdgeIndex(f));
        }
    }
    return ConflictRule{table.take(), "cross", ""};
}

}  // namespace fretwork::pattern::filters
