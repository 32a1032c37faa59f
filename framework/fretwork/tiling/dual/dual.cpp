// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/geometry/plane.hpp>
#include <fretwork/tiling/dual/dual.hpp>

#include <algorithm>
#include <numbers>

namespace fretwork::tiling::detail {
namespace {

using geometry::Point2;
using geometry::Polygon;

/// Where one tile has several points of the rim in a row, those at which the outline turns by less are left
/// out.
constexpr double kSmallestKeptTurn = 20.0 * std::numbers::pi / 180;

/// The circumcenter; of an obtuse triangle, the point of the triangle nearest to it.
Point2 clamped_circumcenter(Point2 a, Point2 b, Point2 c) {
    if (dot(b - a, c - a) <= 0) return between(b, c, 0.5);
    if (dot(a - b, c - b) <= 0) return between(a, c, 0.5);
    if (dot(a - c, b - c) <= 0) return between(a, b, 0.5);
    const Point2 u = b - a;
    const Point2 v = c - a;
    const double scale = 0.5 / cross(u, v);
    const double uu = dot(u, u);
    const double vv = dot(v, v);
    return a + Point2{scale * (v.y * uu - u.y * vv), scale * (u.x * vv - v.x * uu)};
}

class DualBuilder {
  public:
    DualBuilder(const Rim& rim, const Triangulation& triangulation, const Work& work)
        : rim_(rim), triangulation_(triangulation), work_(work) {
        previous_.resize(rim.next.size());
        for (std::size_t b = 0; b < rim.next.size(); ++b)
            previous_[static_cast<std::size_t>(rim.next[b])] = static_cast<int>(b);
        first_triangles_.assign(triangulation.points.size(), -1);
        for (std::size_t i = 0; i < triangulation.triangles.size(); ++i) {
            work_.check();
            for (const int corner : triangulation.triangles[i])
                first_triangles_[static_cast<std::size_t>(corner)] = static_cast<int>(i);
        }
    }

    Dual build() {
        side_ends_.assign(triangulation_.triangles.size(), -1);
        corners_.assign(rim_.points.size(), {});
        add_inner_vertices();
        for (int b = 0; b < triangulation_.rim_count; ++b) add_rim_vertices(b);
        for (auto site = triangulation_.rim_count; site < static_cast<int>(triangulation_.points.size());
             ++site) {
            work_.check();
            dual_.cells.push_back(cell_of(site));
        }
        return std::move(dual_);
    }

  private:
    /// A vertex of the dual at a point of the rim, and the site in whose tile it lies (kShared: in each that
    /// touches the point).
    struct Corner {
        int vertex = -1;
        int owner = -1;
    };
    static constexpr int kShared = -2;

    /// The triangles around a point, counterclockwise; of the rim: from its next to its previous point.
    struct Fan {
        std::vector<int> neighbors;
        std::vector<int> faces;  // face i has neighbors i and i + 1
    };

    [[nodiscard]] Point2 point(int index) const {
        return triangulation_.points[static_cast<std::size_t>(index)];
    }
    [[nodiscard]] bool is_rim(int index) const { return triangulation_.is_rim(index); }

    int add_inner_vertex(Point2 place) {
        dual_.vertices.push_back({place});
        return static_cast<int>(dual_.vertices.size()) - 1;
    }
    int add_vertex_at(int rim_point) {
        const RimPoint& at = rim_.points[static_cast<std::size_t>(rim_point)];
        dual_.vertices.push_back({at.place, at.loop, at.is_corner, at.along});
        return static_cast<int>(dual_.vertices.size()) - 1;
    }
    /// On the outline, at a share of the way to the next point of the rim, or, if it is negative, to the
    /// previous one.
    int add_vertex_beside(int rim_point, double share) {
        const RimPoint& at = rim_.points[static_cast<std::size_t>(rim_point)];
        const ClosedCurve& curve = rim_.curves[static_cast<std::size_t>(at.loop)];
        const int other = share > 0 ? rim_.next[static_cast<std::size_t>(rim_point)]
                                    : previous_[static_cast<std::size_t>(rim_point)];
        double way = rim_.points[static_cast<std::size_t>(other)].along - at.along;
        if (share > 0 && way <= 0) way += curve.length();
        if (share <= 0 && way >= 0) way -= curve.length();
        const double along = at.along + std::abs(share) * way;
        dual_.vertices.push_back({curve.at(along), at.loop, false, along});
        return static_cast<int>(dual_.vertices.size()) - 1;
    }

    void add_inner_vertices() {
        for (std::size_t face = 0; face < triangulation_.triangles.size(); ++face) {
            work_.check();
            const auto& [a, b, c] = triangulation_.triangles[face];
            if (is_rim(a) || is_rim(b) || is_rim(c)) continue;
            side_ends_[face] = add_inner_vertex(clamped_circumcenter(point(a), point(b), point(c)));
        }
    }

    /// The triangle behind the side from a point to the corner before it, seen counterclockwise.
    [[nodiscard]] int clockwise(int triangle, int point) const {
        const auto i = static_cast<std::size_t>(triangle);
        return triangulation_
            .neighbors[i][static_cast<std::size_t>(corner_at(triangulation_.triangles[i], point) + 2) % 3];
    }
    [[nodiscard]] int counterclockwise(int triangle, int point) const {
        const auto i = static_cast<std::size_t>(triangle);
        return triangulation_
            .neighbors[i][static_cast<std::size_t>(corner_at(triangulation_.triangles[i], point) + 1) % 3];
    }
    [[nodiscard]] int corner_after(int triangle, int point, int steps) const {
        const auto& corners = triangulation_.triangles[static_cast<std::size_t>(triangle)];
        return corners[static_cast<std::size_t>(corner_at(corners, point) + steps) % 3];
    }

    /// For a point of the rim, one neighbour more than faces.
    [[nodiscard]] Fan fan_around(int center) const {
        Fan fan;
        int first = first_triangles_[static_cast<std::size_t>(center)];
        if (first < 0) return fan;
        if (is_rim(center)) {
            while (clockwise(first, center) >= 0) first = clockwise(first, center);
        }
        int triangle = first;
        do {
            fan.neighbors.push_back(corner_after(triangle, center, 1));
            fan.faces.push_back(triangle);
            if (counterclockwise(triangle, center) < 0)
                fan.neighbors.push_back(corner_after(triangle, center, 2));
            triangle = counterclockwise(triangle, center);
        } while (triangle >= 0 && triangle != first);
        return fan;
    }

    void add_rim_vertices(int b) {
        work_.check();
        const Fan fan = fan_around(b);
        std::vector<int> sites;
        for (const int neighbor : fan.neighbors) {
            if (!is_rim(neighbor)) sites.push_back(neighbor);
        }
        if (sites.empty()) return;
        const bool is_neck = sites.size() + 2 != fan.neighbors.size();
        const Point2 next = point(fan.neighbors.front());
        const Point2 previous = point(fan.neighbors.back());
        const double turned = turn(point(b) - previous, next - point(b));
        const bool is_corner = rim_.points[static_cast<std::size_t>(b)].is_corner;
        if (is_neck || (is_corner && turned <= 0 && sites.size() > 1)) {
            end_all_sides_at(b, fan);
        } else if (turned > (is_corner ? 0 : sites.size() == 1 ? kSmallestKeptTurn : 10)) {
            const std::size_t owner = most_central(b, sites, previous, next);
            corners_[static_cast<std::size_t>(b)] = {add_vertex_at(b), sites[owner]};
            end_sides_beside(b, fan, static_cast<double>(owner));
        } else {
            end_sides_beside(b, fan, 0.5 * static_cast<double>(sites.size() - 1));
        }
    }

    void end_all_sides_at(int b, const Fan& fan) {
        const int vertex = add_vertex_at(b);
        corners_[static_cast<std::size_t>(b)] = {vertex, kShared};
        for (const int face : fan.faces) side_ends_[static_cast<std::size_t>(face)] = vertex;
    }

    /// The site that lies nearest to the middle of the angle at a corner.
    [[nodiscard]] std::size_t most_central(int b, const std::vector<int>& sites, Point2 previous,
                                           Point2 next) const {
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

    /// Sides between tiles end on the outline around b in their order; side j lies between sites j and j + 1,
    /// and site `middle` (or the side in the middle) lies at b. No side ends beyond half of the way to the
    /// next point of the rim.
    void end_sides_beside(int b, const Fan& fan, double middle) {
        const auto count = static_cast<double>(fan.faces.size()) - 2;  // of sides
        const double most = std::max(middle, count - middle);
        for (std::size_t face = 1; face + 1 < fan.faces.size(); ++face) {
            const double place =
                middle - (static_cast<double>(face) - 1 + 0.5);  // > 0: towards the next point
            side_ends_[static_cast<std::size_t>(fan.faces[face])] =
                place == 0 ? add_vertex_at(b) : add_vertex_beside(b, 0.5 * place / most);
        }
    }

    std::vector<int> cell_of(int site) {
        const Fan fan = fan_around(site);
        std::vector<int> cell = walk(site, fan);
        if (cell.size() >= 3) return cell;
        for (const int neighbor :
             fan.neighbors) {  // hardly more than this tile: every point of the rim counts
            if (is_rim(neighbor) && corners_[static_cast<std::size_t>(neighbor)].vertex < 0 &&
                is_only_touched_by(neighbor, site)) {
                corners_[static_cast<std::size_t>(neighbor)] = {add_vertex_at(neighbor), site};
            }
        }
        return walk(site, fan);
    }
    [[nodiscard]] bool is_only_touched_by(int rim_point, int site) const {
        return std::ranges::all_of(fan_around(rim_point).neighbors,
                                   [&](int neighbor) { return is_rim(neighbor) || neighbor == site; });
    }

    [[nodiscard]] std::vector<int> walk(int site, const Fan& fan) const {
        std::vector<int> cell;
        const auto add = [&](int vertex) {
            if (vertex >= 0 && (cell.empty() || cell.back() != vertex)) cell.push_back(vertex);
        };
        for (std::size_t i = 0; i < fan.neighbors.size(); ++i) {
            if (is_rim(fan.neighbors[i])) {
                const Corner& corner = corners_[static_cast<std::size_t>(fan.neighbors[i])];
                if (corner.owner == site || corner.owner == kShared) add(corner.vertex);
            }
            if (i < fan.faces.size()) add(side_ends_[static_cast<std::size_t>(fan.faces[i])]);
        }
        while (cell.size() > 1 && cell.front() == cell.back()) cell.pop_back();
        return cell;
    }

    const Rim& rim_;
    const Triangulation& triangulation_;
    const Work& work_;
    std::vector<int> first_triangles_;  // for each point one of its triangles
    std::vector<int> previous_;         // for each point of the rim
    Dual dual_;
    std::vector<int> side_ends_;   // for each triangle the vertex of the dual that it gives
    std::vector<Corner> corners_;  // for each point of the rim
};

}  // namespace

Dual dual_of(const Rim& rim, const Triangulation& triangulation, const Work& work) {
    return DualBuilder(rim, triangulation, work).build();
}

Polygon polygon_of(const Dual& dual, std::size_t cell) {
    Polygon polygon;
    for (const int vertex : dual.cells[cell]) polygon.push_back(dual.vertices[vertex].place);
    return polygon;
}

}  // namespace fretwork::tiling::detail
