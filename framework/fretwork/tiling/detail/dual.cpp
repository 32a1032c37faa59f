// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/tiling/detail/dual.hpp>
#include <fretwork/tiling/detail/plane.hpp>

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

#include <map>
#include <numbers>

namespace fretwork::tiling::detail {
namespace {

using Mesh = OpenMesh::TriMesh_ArrayKernelT<>;
using OpenMesh::HalfedgeHandle;
using OpenMesh::VertexHandle;

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
        for (std::size_t i = 0; i < triangulation.points.size(); ++i) mesh_.add_vertex({});
        for (const auto& [a, b, c] : triangulation.triangles) {
            work_.check();
            mesh_.add_face(VertexHandle(a), VertexHandle(b), VertexHandle(c));
        }
    }

    Dual build() {
        flip_ears();
        side_ends_.assign(mesh_.n_faces(), -1);
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

    /// The triangles around a point of the rim, counterclockwise from its next to its previous point.
    struct RimFan {
        std::vector<int> neighbors;
        std::vector<int> faces;  // face i has neighbors i and i + 1
    };

    [[nodiscard]] Point2 point(int index) const {
        return triangulation_.points[static_cast<std::size_t>(index)];
    }
    [[nodiscard]] bool is_rim(int index) const { return triangulation_.is_rim(index); }

    int add_vertex(Point2 place, int loop, bool is_fixed) {
        dual_.vertices.push_back({place, loop, is_fixed});
        return static_cast<int>(dual_.vertices.size()) - 1;
    }
    int add_vertex_at(int rim_point) {
        const RimPoint& at = rim_.points[static_cast<std::size_t>(rim_point)];
        return add_vertex(at.place, at.loop, at.is_corner);
    }

    [[nodiscard]] int rim_vertices_of(OpenMesh::FaceHandle face) const {
        int count = 0;
        for (const VertexHandle v : mesh_.fv_range(face)) count += is_rim(v.idx()) ? 1 : 0;
        return count;
    }

    /// A corner of the outline that a triangle of three rim points cuts off goes to the tile behind it.
    void flip_ears() {
        for (const OpenMesh::EdgeHandle edge : mesh_.edges()) {
            work_.check();
            if (mesh_.is_boundary(edge) || !mesh_.is_flip_ok(edge)) continue;
            for (const unsigned side : {0U, 1U}) {
                const HalfedgeHandle h = mesh_.halfedge_handle(edge, side);
                if (is_ear(h) && is_convex_around(h)) {
                    mesh_.flip(edge);
                    break;
                }
            }
        }
    }
    /// The triangle of h has two sides on the outline, and the one behind h has a site.
    [[nodiscard]] bool is_ear(HalfedgeHandle h) const {
        const HalfedgeHandle next = mesh_.next_halfedge_handle(h);
        return mesh_.is_boundary(mesh_.edge_handle(next)) &&
               mesh_.is_boundary(mesh_.edge_handle(mesh_.prev_halfedge_handle(h))) &&
               !is_rim(opposite_vertex(mesh_.opposite_halfedge_handle(h)));
    }
    [[nodiscard]] int opposite_vertex(HalfedgeHandle h) const {
        return mesh_.to_vertex_handle(mesh_.next_halfedge_handle(h)).idx();
    }
    /// The two triangles of h make a strictly convex quadrilateral.
    [[nodiscard]] bool is_convex_around(HalfedgeHandle h) const {
        const Point2 from = point(mesh_.from_vertex_handle(h).idx());
        const Point2 to = point(mesh_.to_vertex_handle(h).idx());
        const Point2 left = point(opposite_vertex(h));
        const Point2 right = point(opposite_vertex(mesh_.opposite_halfedge_handle(h)));
        return cross(from - left, right - from) > 0 && cross(to - right, left - to) > 0;
    }

    void add_inner_vertices() {
        for (const OpenMesh::FaceHandle face : mesh_.faces()) {
            work_.check();
            if (rim_vertices_of(face) > 0) continue;
            std::array<Point2, 3> places;
            auto place = places.begin();
            for (const VertexHandle v : mesh_.fv_range(face)) *place++ = point(v.idx());
            side_ends_[static_cast<std::size_t>(face.idx())] =
                add_vertex(clamped_circumcenter(places[0], places[1], places[2]), -1, false);
        }
    }

    [[nodiscard]] RimFan fan_around(int rim_point) const {
        RimFan fan;
        HalfedgeHandle h = mesh_.find_halfedge(VertexHandle(rim_point),
                                               VertexHandle(rim_.next[static_cast<std::size_t>(rim_point)]));
        fan.neighbors.push_back(mesh_.to_vertex_handle(h).idx());
        while (!mesh_.is_boundary(h)) {
            fan.faces.push_back(mesh_.face_handle(h).idx());
            h = mesh_.opposite_halfedge_handle(mesh_.prev_halfedge_handle(h));
            fan.neighbors.push_back(mesh_.to_vertex_handle(h).idx());
        }
        return fan;
    }

    void add_rim_vertices(int b) {
        work_.check();
        const RimFan fan = fan_around(b);
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

    void end_all_sides_at(int b, const RimFan& fan) {
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
    /// and site `middle` (or the side in the middle) lies at b.
    void end_sides_beside(int b, const RimFan& fan, double middle) {
        const auto count = static_cast<double>(fan.faces.size()) - 2;  // of sides
        for (std::size_t face = 1; face + 1 < fan.faces.size(); ++face) {
            const double place =
                middle - (static_cast<double>(face) - 1 + 0.5);  // > 0: towards the next point
            const int toward = place > 0 ? fan.neighbors.front() : fan.neighbors.back();
            const Point2 at = between(point(b), point(toward), std::abs(place) / (count + 1));
            side_ends_[static_cast<std::size_t>(fan.faces[face])] =
                add_vertex(at, rim_.points[static_cast<std::size_t>(b)].loop, false);
        }
    }

    /// The neighbours of a site, counterclockwise, and the faces: face i has neighbors i and i + 1.
    [[nodiscard]] RimFan fan_around_site(int site) const {
        RimFan fan;
        const HalfedgeHandle first = mesh_.halfedge_handle(VertexHandle(site));
        HalfedgeHandle h = first;
        do {
            fan.neighbors.push_back(mesh_.to_vertex_handle(h).idx());
            fan.faces.push_back(mesh_.face_handle(h).idx());
            h = mesh_.opposite_halfedge_handle(mesh_.prev_halfedge_handle(h));
        } while (h != first);
        return fan;
    }

    std::vector<int> cell_of(int site) {
        const RimFan fan = fan_around_site(site);
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
        for (const VertexHandle v : mesh_.vv_range(VertexHandle(rim_point))) {
            if (!is_rim(v.idx()) && v.idx() != site) return false;
        }
        return true;
    }

    [[nodiscard]] std::vector<int> walk(int site, const RimFan& fan) const {
        std::vector<int> cell;
        const auto add = [&](int vertex) {
            if (vertex >= 0 && (cell.empty() || cell.back() != vertex)) cell.push_back(vertex);
        };
        for (std::size_t i = 0; i < fan.neighbors.size(); ++i) {
            if (is_rim(fan.neighbors[i])) {
                const Corner& corner = corners_[static_cast<std::size_t>(fan.neighbors[i])];
                if (corner.owner == site || corner.owner == kShared) add(corner.vertex);
            }
            add(side_ends_[static_cast<std::size_t>(fan.faces[i])]);
        }
        while (cell.size() > 1 && cell.front() == cell.back()) cell.pop_back();
        return cell;
    }

    const Rim& rim_;
    const Triangulation& triangulation_;
    const Work& work_;
    Mesh mesh_;
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
    for (const int vertex : dual.cells[cell])
        polygon.push_back(dual.vertices[static_cast<std::size_t>(vertex)].place);
    return polygon;
}

}  // namespace fretwork::tiling::detail
