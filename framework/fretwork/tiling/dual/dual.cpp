// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/geometry/plane.hpp>
#include <fretwork/tiling/dual/dual.hpp>

#include <algorithm>
#include <numbers>

namespace fretwork::tiling::detail {
namespace {

using geometry::Point2;
using geometry::Polygon;

/// The turn of the outline below which a point of the rim is left out, if one tile has several points of the
/// rim in sequence.
constexpr double kSmallestKeptTurn = 20.0 * std::numbers::pi / 180;

/// The circumcenter of a triangle or, for an obtuse triangle, the point of the triangle nearest to it.
Point2 clamped_circumcenter(Point2 a, Point2 b, Point2 c) {
    if (dot(b - a, c - a) <= 0) return between(b, c, 0.5);
    if (dot(a - b, c - b) <= 0) return between(a, c, 0.5);
    if (dot(a - c, b - c) <= 0) return between(a, b, 0.5);
    return circumcenter(a, b, c);
}

class DualBuilder {
  public:
    DualBuilder(const Rim& rim, const Triangulation& triangulation, const SharedTask& task)
        : rim_(rim), triangulation_(triangulation), task_(task) {
        previous_.resize(rim.next.size());
        for (const PointIndex b : rim.next.indices()) previous_[rim.next[b]] = b;
        first_triangles_.resize(triangulation.points.size());
        for (const TriangleIndex triangle : triangulation.triangles.indices()) {
            task_.check();
            for (const PointIndex corner : triangulation.triangles[triangle])
                first_triangles_[corner] = triangle;
        }
    }

    Dual build() {
        side_ends_.resize(triangulation_.triangles.size());
        corners_.resize(rim_.points.size());
        add_inner_vertices();
        for (const PointIndex b : rim_.points.indices()) add_rim_vertices(b);
        for (const PointIndex site : triangulation_.points.indices()) {
            if (is_rim(site)) continue;
            task_.check();
            dual_.cells.push_back(cell_of(site));
        }
        return std::move(dual_);
    }

  private:
    /// A vertex of the dual at a point of the rim, and the site whose tile has this vertex (none: every tile
    /// that touches the point).
    struct Corner {
        DualVertexIndex vertex;
        PointIndex owner;
    };

    /// The triangles around a point, counterclockwise; around a point of the rim, from its next point to its
    /// previous point.
    struct Fan {
        std::vector<PointIndex> neighbors;
        std::vector<TriangleIndex> faces;  // face i has neighbors i and i + 1
    };

    [[nodiscard]] Point2 point(PointIndex index) const { return triangulation_.points[index]; }
    [[nodiscard]] bool is_rim(PointIndex index) const { return triangulation_.is_rim(index); }

    DualVertexIndex add(const DualVertex& vertex) {
        dual_.vertices.push_back(vertex);
        return DualVertexIndex(dual_.vertices.size() - 1);
    }
    DualVertexIndex add_vertex_at(PointIndex rim_point) {
        const RimPoint& at = rim_.points[rim_point];
        return add({at.place, at.loop, at.is_corner, at.along});
    }
    /// Add a vertex on the outline, at a share of the way to the next point of the rim or, for a negative
    /// share, to the previous point.
    DualVertexIndex add_vertex_beside(PointIndex rim_point, double share) {
        const RimPoint& at = rim_.points[rim_point];
        const ClosedCurve& curve = rim_.curves[at.loop];
        const PointIndex other = share > 0 ? rim_.next[rim_point] : previous_[rim_point];
        double way = rim_.points[other].along - at.along;
        if (share > 0 && way <= 0) way += curve.length();
        if (share <= 0 && way >= 0) way -= curve.length();
        const double along = at.along + std::abs(share) * way;
        return add({curve.at(along), at.loop, false, along});
    }

    void add_inner_vertices() {
        for (const TriangleIndex face : triangulation_.triangles.indices()) {
            task_.check();
            const auto& [a, b, c] = triangulation_.triangles[face];
            if (is_rim(a) || is_rim(b) || is_rim(c)) continue;
            side_ends_[face] = add({clamped_circumcenter(point(a), point(b), point(c))});
        }
    }

    /// The neighbour of a triangle in the clockwise direction around a point.
    [[nodiscard]] TriangleIndex clockwise(TriangleIndex triangle, PointIndex point) const {
        const int corner = corner_at(triangulation_.triangles[triangle], point);
        return triangulation_.neighbors[triangle][(corner + 2) % 3];
    }
    [[nodiscard]] TriangleIndex counterclockwise(TriangleIndex triangle, PointIndex point) const {
        const int corner = corner_at(triangulation_.triangles[triangle], point);
        return triangulation_.neighbors[triangle][(corner + 1) % 3];
    }
    [[nodiscard]] PointIndex corner_after(TriangleIndex triangle, PointIndex point, int steps) const {
        const auto& corners = triangulation_.triangles[triangle];
        return corners[(corner_at(corners, point) + steps) % 3];
    }

    /// The fan around a point; a point of the rim has one more neighbour than faces.
    [[nodiscard]] Fan fan_around(PointIndex center) const {
        Fan fan;
        TriangleIndex first = first_triangles_[center];
        if (!first.is_valid()) return fan;
        if (is_rim(center)) {
            while (clockwise(first, center).is_valid()) first = clockwise(first, center);
        }
        TriangleIndex triangle = first;
        do {
            fan.neighbors.push_back(corner_after(triangle, center, 1));
            fan.faces.push_back(triangle);
            if (!counterclockwise(triangle, center).is_valid())
                fan.neighbors.push_back(corner_after(triangle, center, 2));
            triangle = counterclockwise(triangle, center);
        } while (triangle.is_valid() && triangle != first);
        return fan;
    }

    void add_rim_vertices(PointIndex b) {
        task_.check();
        const Fan fan = fan_around(b);
        std::vector<PointIndex> sites;
        for (const PointIndex neighbor : fan.neighbors) {
            if (!is_rim(neighbor)) sites.push_back(neighbor);
        }
        if (sites.empty()) return;
        const bool is_neck = sites.size() + 2 != fan.neighbors.size();
        const Point2 next = point(fan.neighbors.front());
        const Point2 previous = point(fan.neighbors.back());
        const double turned = turn(point(b) - previous, next - point(b));
        const bool is_corner = rim_.points[b].is_corner;
        if (is_neck || (is_corner && turned <= 0 && sites.size() > 1)) {
            end_all_sides_at(b, fan);
        } else if (turned > (is_corner ? 0 : sites.size() == 1 ? kSmallestKeptTurn : 10)) {
            const std::size_t owner = most_central(b, sites, previous, next);
            corners_[b] = {add_vertex_at(b), sites[owner]};
            end_sides_beside(b, fan, static_cast<double>(owner));
        } else {
            end_sides_beside(b, fan, 0.5 * static_cast<double>(sites.size() - 1));
        }
    }

    void end_all_sides_at(PointIndex b, const Fan& fan) {
        const DualVertexIndex vertex = add_vertex_at(b);
        corners_[b] = {vertex, {}};
        for (const TriangleIndex face : fan.faces) side_ends_[face] = vertex;
    }

    /// The index of the site nearest to the bisector of the angle at a corner.
    [[nodiscard]] std::size_t most_central(PointIndex b, const std::vector<PointIndex>& sites,
                                           Point2 previous, Point2 next) const {
        const Point2 to_next = next - point(b);
        const double half = 0.5 * (std::numbers::pi - turn(point(b) - previous, to_next));
        std::size_t best = 0;
        const auto off_middle = [&](std::size_t i) {
            return std::abs(turn(to_next, point(sites[i]) - point(b)) - half);
        };
        for (std::size_t i = 1; i < sites.size(); ++i) {
            if (off_middle(i) < off_middle(best) - 1e-9) best = i;
        }
        return best;
    }

    /// Put the ends of the sides between tiles on the outline around b, in order. Side j lies between sites j
    /// and j + 1, and site `middle` (or the middle side) lies at b. No side ends beyond half of the way to
    /// the next or the previous point of the rim.
    void end_sides_beside(PointIndex b, const Fan& fan, double middle) {
        const auto count = static_cast<double>(fan.faces.size()) - 2;  // number of sides
        const double most = std::max(middle, count - middle);
        for (std::size_t face = 1; face + 1 < fan.faces.size(); ++face) {
            const double place =
                middle - (static_cast<double>(face) - 1 + 0.5);  // above zero: towards the next point
            side_ends_[fan.faces[face]] =
                place == 0 ? add_vertex_at(b) : add_vertex_beside(b, 0.5 * place / most);
        }
    }

    Cell cell_of(PointIndex site) {
        const Fan fan = fan_around(site);
        Cell cell = walk(site, fan);
        if (cell.size() >= 3) return cell;
        // The outline is hardly larger than this tile, so every point of the rim matters.
        for (const PointIndex neighbor : fan.neighbors) {
            if (is_rim(neighbor) && !corners_[neighbor].vertex.is_valid() &&
                is_only_touched_by(neighbor, site)) {
                corners_[neighbor] = {add_vertex_at(neighbor), site};
            }
        }
        return walk(site, fan);
    }
    [[nodiscard]] bool is_only_touched_by(PointIndex rim_point, PointIndex site) const {
        return std::ranges::all_of(fan_around(rim_point).neighbors,
                                   [&](PointIndex neighbor) { return is_rim(neighbor) || neighbor == site; });
    }

    [[nodiscard]] Cell walk(PointIndex site, const Fan& fan) const {
        Cell cell;
        const auto add = [&](DualVertexIndex vertex) {
            if (vertex.is_valid() && (cell.empty() || cell.back() != vertex)) cell.push_back(vertex);
        };
        for (std::size_t i = 0; i < fan.neighbors.size(); ++i) {
            if (is_rim(fan.neighbors[i])) {
                const Corner& corner = corners_[fan.neighbors[i]];
                if (corner.owner == site || !corner.owner.is_valid()) add(corner.vertex);
            }
            if (i < fan.faces.size()) add(side_ends_[fan.faces[i]]);
        }
        while (cell.size() > 1 && cell.front() == cell.back()) cell.pop_back();
        return cell;
    }

    const Rim& rim_;
    const Triangulation& triangulation_;
    const SharedTask& task_;
    base::IndexVector<PointIndex, TriangleIndex> first_triangles_;  // a triangle of each point
    base::IndexVector<PointIndex, PointIndex> previous_;            // previous point of each point of the rim
    Dual dual_;
    base::IndexVector<TriangleIndex, DualVertexIndex> side_ends_;  // vertex that each triangle gives
    base::IndexVector<PointIndex, Corner> corners_;                // corner of each point of the rim, if any
};

}  // namespace

Dual dual_of(const Rim& rim, const Triangulation& triangulation, const SharedTask& task) {
    return DualBuilder(rim, triangulation, task).build();
}

Polygon polygon_of(const Dual& dual, std::size_t cell) {
    Polygon polygon;
    for (const DualVertexIndex vertex : dual.cells[cell]) polygon.push_back(dual.vertices[vertex].place);
    return polygon;
}

}  // namespace fretwork::tiling::detail
