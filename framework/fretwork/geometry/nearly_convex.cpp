// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/geometry/internal/message_text.hpp>
#include <fretwork/geometry/nearly_convex.hpp>
#include <fretwork/geometry/plane.hpp>

#include <algorithm>
#include <limits>

namespace fretwork::geometry {
namespace {

/// A vertex with its neighbours.
struct Bend {
    Point2 before;
    Point2 vertex;
    Point2 after;
    /// True if the polygon turns right at the vertex, by an exact test.
    [[nodiscard]] bool is_inward() const { return is_convex({after, vertex, before}); }
    /// The distance of the vertex from the segment between its neighbours, m.
    [[nodiscard]] double depth() const { return distance(vertex, nearest_on_segment(before, after, vertex)); }
};

Bend bend_at(const Polygon& polygon, std::size_t i) {
    return {polygon[(i + polygon.size() - 1) % polygon.size()], polygon[i],
            polygon[(i + 1) % polygon.size()]};
}

double shortest_side(const Polygon& polygon) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < polygon.size(); ++i)
        least = std::min(least, distance(polygon[i], polygon[(i + 1) % polygon.size()]));
    return least;
}

}  // namespace

bool is_nearly_convex(const Polygon& polygon) {
    if (is_convex(polygon)) return true;
    if (polygon.size() < 4) return false;
    const double most = kInwardTolerance * shortest_side(polygon);
    Polygon kept = polygon;
    std::size_t looked_at = 0;  // vertices since the last removal
    for (std::size_t i = 0; looked_at < kept.size() && kept.size() > 3;) {
        i %= kept.size();
        const Bend bend = bend_at(kept, i);
        if (!bend.is_inward()) {
            ++i;
            ++looked_at;
            continue;
        }
        if (!(bend.depth() <= most)) return false;
        kept.erase(kept.begin() + static_cast<std::ptrdiff_t>(i));
        i = i == 0 ? kept.size() - 1 : i - 1;  // the vertex before may bend inwards now
        looked_at = 0;
    }
    return is_convex(kept);
}

std::string inward_bend_text(const Polygon& polygon) {
    if (polygon.size() < 3 || !(signed_area(polygon) > 0.0)) return "";
    double most = 0.0;
    Point2 place;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Bend bend = bend_at(polygon, i);
        if (!bend.is_inward() || bend.depth() <= most) continue;
        most = bend.depth();
        place = bend.vertex;
    }
    return most > 0.0 ? ": it bends inwards at " + place_text(place) + " by " + metres(most) : "";
}

}  // namespace fretwork::geometry
