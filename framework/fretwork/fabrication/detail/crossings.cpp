// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/fabrication/detail/bar_angles.hpp>
#include <fretwork/fabrication/detail/length_text.hpp>
#include <fretwork/geometry/box_grid.hpp>
#include <fretwork/geometry/plane.hpp>

#include <optional>
#include <string>

namespace fretwork::fabrication::detail {
namespace {

using geometry::Box;
using geometry::Point2;
using geometry::Segment;

/// Bars nearer than this touch: rounding may leave such a gap between a node and a bar through the node.
constexpr double kTouching = 1e-9;  // m
/// Bars with a common node and a smaller angle between them lie over each other.
constexpr double kSameDirection = 1e-6;  // rad

Segment segment(const BarPlan& plan, const Bar& bar) {
    return {plan.nodes[bar.nodes[0]], plan.nodes[bar.nodes[1]]};
}

/// The place where two bars without a common node meet; none if they do not.
std::optional<Point2> meeting_place(const Segment& a, const Segment& b) {
    if (do_cross(a, b)) {
        const Point2 along = a[1] - a[0];
        const double share = cross(b[0] - a[0], b[1] - b[0]) / cross(along, b[1] - b[0]);
        return a[0] + share * along;
    }
    const auto touches = [](const Point2& point, const Segment& line) {
        return distance(point, nearest_on_segment(line[0], line[1], point)) <= kTouching;
    };
    for (const Point2& end : a)
        if (touches(end, b)) return end;
    for (const Point2& end : b)
        if (touches(end, a)) return end;
    return std::nullopt;
}

/// The common node of two bars that lie over each other there; none if they do not.
std::optional<Point2> overlap_at_common_node(const BarPlan& plan, const Bar& a, const Bar& b) {
    for (std::size_t i = 0; i < 2; ++i) {
        for (std::size_t j = 0; j < 2; ++j) {
            if (a.nodes[i] != b.nodes[j]) continue;
            const Point2 node = plan.nodes[a.nodes[i]];
            const Point2 along_a = unit(plan.nodes[a.nodes[1 - i]] - node);
            const Point2 along_b = unit(plan.nodes[b.nodes[1 - j]] - node);
            if (distance(along_a, along_b) < kSameDirection) return node;
        }
    }
    return std::nullopt;
}

bool have_common_node(const Bar& a, const Bar& b) {
    return a.nodes[0] == b.nodes[0] || a.nodes[0] == b.nodes[1] || a.nodes[1] == b.nodes[0] ||
           a.nodes[1] == b.nodes[1];
}

[[noreturn]] void fail(const Bar& a, const Bar& b, const Point2& place) {
    const std::string tiles = a.tile == b.tile ? "tile " + std::to_string(a.tile) + ": two of its beams"
                                               : "tiles " + std::to_string(a.tile) + " and " +
                                                     std::to_string(b.tile) + ": beams of theirs";
    throw base::GeometryError(tiles + " cross or lie over each other at " + place_text(place) +
                              "; bars of one sheet may meet only at nodes");
}

}  // namespace

void require_no_crossings(const BarPlan& plan) {
    std::vector<Box> boxes;
    for (const Bar& bar : plan.bars) {
        const Segment line = segment(plan, bar);
        boxes.push_back(grown(box_of(line), kTouching));
    }
    const geometry::BoxGrid grid(boxes);
    for (std::size_t i = 0; i < plan.bars.size(); ++i) {
        const Bar& bar = plan.bars[i];
        for (const std::size_t j : grid.meeting(boxes[i])) {
            if (j <= i) continue;
            const Bar& other = plan.bars[j];
            const auto place = have_common_node(bar, other)
                                   ? overlap_at_common_node(plan, bar, other)
                                   : meeting_place(segment(plan, bar), segment(plan, other));
            if (place) fail(bar, other, *place);
        }
    }
}

}  // namespace fretwork::fabrication::detail
