// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/outlines/detail/outline_readers.hpp>

#include <algorithm>
#include <cmath>

namespace fretwork::outlines::detail {
Outline outline_of(std::vector<Loop> loops) {
    if (loops.empty()) throw base::GeometryError("there is no closed curve");
    for (Loop& loop : loops) {
        geometry::remove_repeated_points(loop.points, kClosingShare * kFlatteningTolerance);
        if (loop.points.size() < 3) throw base::GeometryError(loop.place + " encloses no area");
    }
    const auto size = [](const Loop& loop) { return std::abs(geometry::signed_area(loop.points)); };
    const auto largest = std::max_element(loops.begin(), loops.end(),
                                          [&](const Loop& a, const Loop& b) { return size(a) < size(b); });
    std::rotate(loops.begin(), largest, largest + 1);
    std::string names;  // make_outline() names holes by number
    std::vector<geometry::Polygon> holes;
    for (std::size_t i = 1; i < loops.size(); ++i) {
        names += "; hole " + std::to_string(i - 1) + " is " + loops[i].place;
        holes.push_back(std::move(loops[i].points));
    }
    try {
        return make_outline(std::move(loops.front().points), std::move(holes));
    } catch (const base::GeometryError& error) {
        base::ErrorData data = error.data();
        data.problem += " (the boundary is " + loops.front().place + names + ")";
        throw base::GeometryError(std::move(data));
    }
}

}  // namespace fretwork::outlines::detail
