// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/tiling/detail/outline_readers.hpp>

#include <algorithm>
#include <cmath>

namespace fretwork::tiling::detail {
void remove_repeated_points(pattern::Polygon& points, double nearest) {
    const auto is_near = [&](const pattern::Point2& a, const pattern::Point2& b) {
        return a == b || std::hypot(a.x - b.x, a.y - b.y) < nearest;
    };
    points.erase(std::unique(points.begin(), points.end(), is_near), points.end());
    while (points.size() > 1 && is_near(points.front(), points.back())) points.pop_back();
}

Outline outline_of(std::vector<Loop> loops) {
    if (loops.empty()) throw base::GeometryError("there is no closed curve");
    for (Loop& loop : loops) {
        remove_repeated_points(loop.points, kClosingShare * kFlatteningTolerance);
        if (loop.points.size() < 3) throw base::GeometryError(loop.place + " encloses no area");
    }
    const auto size = [](const Loop& loop) { return std::abs(pattern::signed_area(loop.points)); };
    const auto largest = std::max_element(loops.begin(), loops.end(),
                                          [&](const Loop& a, const Loop& b) { return size(a) < size(b); });
    std::rotate(loops.begin(), largest, largest + 1);
    std::string names;  // make_outline speaks of holes by number
    std::vector<pattern::Polygon> holes;
    for (std::size_t i = 1; i < loops.size(); ++i) {
        names += "; hole " + std::to_string(i - 1) + " is " + loops[i].place;
        holes.push_back(std::move(loops[i].points));
    }
    try {
        return make_outline(std::move(loops.front().points), std::move(holes));
    } catch (const base::GeometryError& error) {
        throw base::GeometryError(std::string(error.what()) + " (the boundary is " + loops.front().place +
                                  names + ")");
    }
}

}  // namespace fretwork::tiling::detail
