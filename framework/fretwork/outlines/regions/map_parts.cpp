// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/geometry/plane.hpp>
#include <fretwork/outlines/detail/outline_readers.hpp>
#include <fretwork/outlines/outline_check.hpp>
#include <fretwork/outlines/regions/map_parts.hpp>
#include <fretwork/outlines/regions/welding.hpp>

#include <algorithm>
#include <limits>
#include <map>
#include <numbers>
#include <optional>
#include <unordered_map>
#include <unordered_set>

namespace fretwork::outlines::detail {
namespace {

using geometry::Point2;
using geometry::Polygon;

using Halfedge = PlanarMap::Halfedge_handle;
using Face = PlanarMap::Face_handle;

/// The largest number of rounds. If lines were welded, or if rounding crossings to doubles has made new
/// crossings (which is rare), one more round is needed, but never many.
constexpr int kMostRounds = 5;

/// A closed curve with the filled area on its left.
struct Loop {
    Polygon points;
    int touches = 0;
    int first_side = 0;  ///< smallest number of its sides, which keeps loops in the order of their file
};

bool is_rim(Halfedge halfedge) {
    return halfedge->face()->data().is_filled && !halfedge->twin()->face()->data().is_filled;
}

/// The next halfedge along the rim of the filled area, chosen so that parts that only touch at a point stay
/// separate.
Halfedge next_on_rim(Halfedge halfedge) {
    Halfedge next = halfedge->next();
    while (!is_rim(next)) next = next->twin()->next();
    return next;
}

void mark_parts(PlanarMap& map) {
    int parts = 0;
    for (auto face = map.faces_begin(); face != map.faces_end(); ++face) face->data().part = -1;
    for (auto face = map.faces_begin(); face != map.faces_end(); ++face) {
        if (!face->data().is_filled || face->data().part >= 0) continue;
        std::vector<Face> stack{face};
        face->data().part = parts;
        while (!stack.empty()) {
            const Face here = stack.back();
            stack.pop_back();
            for (const Halfedge halfedge : halfedges_of(here)) {
                const Face other = halfedge->twin()->face();
                if (!other->data().is_filled || other->data().part >= 0) continue;
                other->data().part = parts;
                stack.push_back(other);
            }
        }
        ++parts;
    }
}

struct Corner {
    Point2 place;
    bool is_touch;  // true if the loop passes the corner more than once
};

/// Remove corners so near to a touching point that there is no room to open it.
void leave_room_at_touches(std::vector<Corner>& corners, double room) {
    const auto is_beside = [&](std::size_t i) {
        const std::size_t n = corners.size();
        const auto is_near = [&](const Corner& other) {
            return other.is_touch && distance(other.place, corners[i].place) < room;
        };
        return !corners[i].is_touch && (is_near(corners[(i + n - 1) % n]) || is_near(corners[(i + 1) % n]));
    };
    for (std::size_t i = 0; i < corners.size();) {
        if (!is_beside(i)) {
            ++i;
            continue;
        }
        corners.erase(corners.begin() + i);
        i -= std::min<std::size_t>(i, 1);  // the corner before may now be next to a touching point
    }
}

/// The polygon through the corners; a corner at a touching point is moved into the filled area.
Polygon opened(std::vector<Corner> corners, double tolerance) {
    leave_room_at_touches(corners, 4 * tolerance);
    const std::size_t n = corners.size();
    Polygon apart;
    for (std::size_t i = 0; i < n; ++i) {
        apart.push_back(corners[i].place);
        if (!corners[i].is_touch) continue;
        const Point2 in = corners[i].place - corners[(i + n - 1) % n].place;
        const Point2 out = corners[(i + 1) % n].place - corners[i].place;
        const double left = std::atan2(out.y, out.x) + 0.5 * (std::numbers::pi - turn(in, out));
        const double reach = std::min({tolerance, 0.3 * length(in), 0.3 * length(out)});
        apart[i] = corners[i].place + reach * Point2{std::cos(left), std::sin(left)};
    }
    return apart;
}

/// A closed chain of halfedges that begins at the start of its first side (by number), so that outlines keep
/// the first point from their file.
struct Row {
    std::vector<Halfedge> along;
    int first_side = std::numeric_limits<int>::max();
};
Row row_from(Halfedge first, const std::vector<LineMap::Side>& sides) {
    Row row;
    std::size_t start = 0;
    for (Halfedge next = first; row.along.empty() || next != first; next = next_on_rim(next)) {
        row.along.push_back(next);
        const int least = *std::ranges::min_element(next->curve().data());
        if (least >= row.first_side) continue;
        row.first_side = least;
        const bool is_forward =
            (next->direction() == CGAL::ARR_LEFT_TO_RIGHT ? 1 : -1) == sides[least].direction;
        start = row.along.size() - (is_forward ? 1 : 0);
    }
    // Points are the targets of halfedges, so the halfedge that ends at the first point comes first.
    const std::size_t n = row.along.size();
    std::rotate(row.along.begin(), row.along.begin() + (start + n - 1) % n, row.along.end());
    return row;
}

/// The loop along a chain of halfedges. Points at which the rim goes straight on stay, because they are
/// points of the file, or crossings.
Loop loop_of(const Row& row, double tolerance) {
    std::unordered_map<const void*, int> visits;
    for (const Halfedge halfedge : row.along) ++visits[&*halfedge->target()];
    Loop loop{.points = {}, .first_side = row.first_side};
    for (const auto& [vertex, count] : visits) loop.touches += count > 1 ? 1 : 0;
    std::vector<Corner> corners;
    for (const Halfedge halfedge : row.along)
        corners.push_back({place_of(halfedge->target()), visits[&*halfedge->target()] > 1});
    loop.points = opened(std::move(corners), tolerance);
    return loop;
}

struct PartLoops {
    Polygon boundary;
    // By first side; pieces of one side may belong to the rims of several holes.
    std::multimap<int, Polygon> holes;
};

/// True if a curve is narrower than `tolerance`; crossings of two nearly equal lines leave such curves.
bool is_thin(const Polygon& points, double tolerance) {
    return points.size() < 3 || 2 * std::abs(geometry::signed_area(points)) < tolerance * perimeter(points);
}

struct Collected {
    std::map<int, PartLoops> parts;
    Region counts;
};

Collected collect(LineMap& lines, double tolerance) {
    PlanarMap& map = lines.map;
    mark_parts(map);
    Collected collected;
    std::unordered_set<const void*> done;
    for (auto halfedge = map.halfedges_begin(); halfedge != map.halfedges_end(); ++halfedge) {
        if (!is_rim(halfedge) || done.contains(&*halfedge)) continue;
        const int part = halfedge->face()->data().part;
        const Row row = row_from(halfedge, lines.sides);
        for (const Halfedge next : row.along) done.insert(&*next);
        Loop loop = loop_of(row, tolerance);
        // Lines that nearly coincide cross close to points of the file.
        geometry::remove_repeated_points(loop.points, kClosingShare * tolerance);
        PartLoops& loops = collected.parts[part];
        const bool is_boundary = geometry::signed_area(loop.points) > 0;
        if (is_thin(loop.points, tolerance)) {
            if (!is_boundary) ++collected.counts.slits;
            continue;
        }
        collected.counts.touches += loop.touches;
        if (is_boundary)
            loops.boundary = std::move(loop.points);
        else
            loops.holes.emplace(loop.first_side, std::move(loop.points));
    }
    std::erase_if(collected.parts, [](const auto& part) { return part.second.boundary.empty(); });
    return collected;
}

int weld_parts(std::map<int, PartLoops>& parts, double width) {
    std::vector<Polygon*> loops;
    for (auto& [number, part] : parts) {
        loops.push_back(&part.boundary);
        for (auto& [side, hole] : part.holes) loops.push_back(&hole);
    }
    return weld(loops, width);
}

/// The parts as outlines; nothing if a part crosses itself because of rounding.
std::optional<std::vector<Outline>> outlines_of(const std::map<int, PartLoops>& parts) {
    std::vector<Outline> outlines;
    for (const auto& [number, part] : parts) {
        std::vector<Polygon> loops{part.boundary};
        for (const auto& [side, hole] : part.holes) loops.push_back(hole);
        if (outline_flaw(loops, {})) return std::nullopt;
        outlines.push_back({part.boundary, {loops.begin() + 1, loops.end()}});
    }
    return outlines;
}

/// The map of the rounded loops. The same area is filled, because boundaries run counterclockwise and holes
/// clockwise.
LineMap map_of(const std::map<int, PartLoops>& parts) {
    std::vector<MapLine> lines;
    for (const auto& [number, part] : parts) {
        lines.push_back({&part.boundary});
        for (const auto& [side, hole] : part.holes) lines.push_back({&hole});
    }
    LineMap made = make_line_map(lines);
    int winding = 0;
    visit_faces(made, {.cross = [&](int, int change) { winding += change; },
                       .look = [&](Face face) { face->data().is_filled = winding > 0; }});
    return made;
}

}  // namespace

Region region_of_map(LineMap& lines, double tolerance) {
    Collected collected = collect(lines, tolerance);
    Region region = collected.counts;
    std::optional<std::vector<Outline>> outlines;
    for (int round = 1;; ++round) {
        const bool is_last = round == kMostRounds;
        const int welded = is_last ? 0 : weld_parts(collected.parts, kWeldShare * tolerance);
        region.is_welded = region.is_welded || welded > 0;
        if (welded == 0) outlines = outlines_of(collected.parts);
        if (outlines || is_last) break;
        LineMap again = map_of(collected.parts);
        collected = collect(again, tolerance);
        region.touches += collected.counts.touches;
    }
    if (!outlines)
        throw base::GeometryError("its curves cross at places too near to each other to tell apart");
    region.parts = std::move(*outlines);
    std::ranges::stable_sort(region.parts, std::ranges::greater{}, area_of);
    return region;
}

Polygon polygon_around(PlanarMap::Ccb_halfedge_const_circulator first) {
    Polygon points;
    auto next = first;
    do {
        points.push_back(place_of(next->target()));
    } while (++next != first);
    return points;
}

geometry::Box box_of(const std::vector<Polygon>& polygons) {
    std::optional<geometry::Box> box;
    for (const Polygon& polygon : polygons) {
        if (polygon.empty()) continue;
        const geometry::Box own = geometry::box_of(polygon);
        box = box ? geometry::united(*box, own) : own;
    }
    return box.value_or(geometry::Box{});
}

}  // namespace fretwork::outlines::detail
