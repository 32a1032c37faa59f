// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/geometry/internal/place_limits.hpp>
#include <fretwork/geometry/plane.hpp>
#include <fretwork/simulation/detail/line_bearers.hpp>
#include <fretwork/simulation/load_cases/detail/side_strip.hpp>
#include <fretwork/tiling/tessellation.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace fretwork::simulation::detail {
namespace {

using geometry::Point2;
using tiling::InterfaceIndex;
using tiling::Tessellation;

/// A side that only one tile has.
struct RimSide {
    std::array<Point2, 2> ends;
    std::vector<InterfaceIndex> nodes;
    [[nodiscard]] double length() const { return geometry::distance(ends[0], ends[1]); }
};

/// The closed lines of the rim, side after side.
std::vector<std::vector<RimSide>> rim_of(const Tessellation& tessellation) {
    std::vector<std::vector<RimSide>> rim;
    for (const auto& line : tiling::rim_sides(tessellation)) {
        std::vector<RimSide>& own = rim.emplace_back();
        for (const tiling::RimSide& side : line)
            own.push_back({{tessellation.vertices[side.from], tessellation.vertices[side.to]}, side.nodes});
    }
    return rim;
}

void add(const RimSide& side, double length, std::vector<LineBearer>& bearers) {
    for (const InterfaceIndex node : side.nodes)
        bearers.push_back({node, length / static_cast<double>(side.nodes.size())});
}

/// The bearers on rim sides that face one side of the bounding box, with all of their nodes along it.
std::vector<LineBearer> along_side(Side side, const Tessellation& tessellation) {
    constexpr double kLeastShare = 1e-9;  // of a rim side's length: less is rounding
    const SideStrip strip(side, tessellation);
    std::vector<LineBearer> bearers;
    for (const auto& loop : rim_of(tessellation)) {
        for (const RimSide& own : loop) {
            const bool is_near = std::ranges::all_of(own.nodes, [&](InterfaceIndex node) {
                return strip.contains(tessellation.interface_nodes[node]);
            });
            const double length = length_along(side, own.ends[0], own.ends[1]);
            if (is_near && length > kLeastShare * own.length()) add(own, length, bearers);
        }
    }
    if (bearers.empty())
        throw base::InputError(
            "no side of a tile lies along this side of the surface; a line load between two points of the "
            "rim is possible");
    return bearers;
}

struct RimPlace {
    std::size_t loop = 0;
    double way = 0.0;  ///< m, from where the closed line begins
    double distance = std::numeric_limits<double>::infinity();
};

RimPlace nearest_place(const std::vector<std::vector<RimSide>>& rim, const Point2& point) {
    RimPlace nearest;
    for (std::size_t loop = 0; loop < rim.size(); ++loop) {
        double way = 0.0;
        for (const RimSide& side : rim[loop]) {
            const Point2 along{side.ends[1].x - side.ends[0].x, side.ends[1].y - side.ends[0].y};
            const Point2 arm{point.x - side.ends[0].x, point.y - side.ends[0].y};
            const double share = std::clamp(
                (along.x * arm.x + along.y * arm.y) / (along.x * along.x + along.y * along.y), 0.0, 1.0);
            const double distance = std::hypot(arm.x - share * along.x, arm.y - share * along.y);
            if (distance < nearest.distance) nearest = {loop, way + share * side.length(), distance};
            way += side.length();
        }
    }
    return nearest;
}

double length_of(const std::vector<RimSide>& loop) {
    double sum = 0.0;
    for (const RimSide& side : loop) sum += side.length();
    return sum;
}

std::vector<LineBearer> between(const std::array<Point2, 2>& ends, const Tessellation& tessellation) {
    for (std::size_t i = 0; i < ends.size(); ++i) {
        if (!geometry::is_within_limits(ends[i]))
            throw base::InputError(geometry::beyond_limits_text("point " + std::to_string(i), ends[i]));
    }
    const auto rim = rim_of(tessellation);
    RimPlace from = nearest_place(rim, ends[0]);
    RimPlace to = nearest_place(rim, ends[1]);
    if (from.loop != to.loop)
        throw base::InputError("the two points lie on different lines of the rim, such as a hole's");
    const auto& loop = rim[from.loop];
    const double whole = length_of(loop);
    const auto way_on = [whole](double a, double b) { return b >= a ? b - a : b - a + whole; };
    if (way_on(from.way, to.way) > way_on(to.way, from.way)) std::swap(from, to);
    const double span = way_on(from.way, to.way);
    if (!(span > 0.0)) throw base::InputError("both points lie nearest to one place of the rim");
    std::vector<LineBearer> bearers;
    double start = 0.0;
    for (const RimSide& side : loop) {
        // The part of the side that lies on the way, which may run past the beginning of the line.
        double length = 0.0;
        for (const double turn : {0.0, whole}) {
            const double low = std::max(start + turn, from.way);
            const double high = std::min(start + side.length() + turn, from.way + span);
            length += std::max(0.0, high - low);
        }
        if (length > 0.0) add(side, length, bearers);
        start += side.length();
    }
    return bearers;
}

}  // namespace

std::vector<LineBearer> line_bearers(const Selection& where, const Tessellation& tessellation) {
    if (const auto* at = std::get_if<NodesAtSide>(&where)) return along_side(at->side, tessellation);
    const auto* ends = std::get_if<NodesNearest>(&where);
    if (ends == nullptr || ends->points.size() != 2)
        throw base::InputError("a line load runs along a side, or between two points of the rim");
    return between({ends->points[0], ends->points[1]}, tessellation);
}

}  // namespace fretwork::simulation::detail
