// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/geometry/plane.hpp>
#include <fretwork/tiling/remeshing/triangulation.hpp>

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <deque>

namespace fretwork::tiling::detail {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
struct FaceInfo {
    int depth = -1;            // number of loops between the face and infinity; odd: inside
    TriangleIndex triangle{};  // index of a face inside
};
struct VertexInfo {
    PointIndex point{};
};
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<VertexInfo, Kernel>;
using FaceBase =
    CGAL::Triangulation_face_base_with_info_2<FaceInfo, Kernel,
                                              CGAL::Constrained_triangulation_face_base_2<Kernel>>;
using Delaunay =
    CGAL::Constrained_Delaunay_triangulation_2<Kernel,
                                               CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>,
                                               CGAL::No_constraint_intersection_requiring_constructions_tag>;

/// Count, for every face, the loops between the face and infinity.
void mark_depths(Delaunay& delaunay, const SharedTask& task) {
    std::deque<Delaunay::Face_handle> open{delaunay.infinite_face()};
    delaunay.infinite_face()->info().depth = 0;
    while (!open.empty()) {
        task.check();
        const Delaunay::Face_handle face = open.front();
        open.pop_front();
        for (int i = 0; i < 3; ++i) {
            const Delaunay::Face_handle other = face->neighbor(i);
            if (other->info().depth >= 0) continue;
            const bool crosses_rim = face->is_constrained(i);
            other->info().depth = face->info().depth + (crosses_rim ? 1 : 0);
            // Visit a whole region before the next one, so that each face gets its smallest depth.
            crosses_rim ? open.push_back(other) : open.push_front(other);
        }
    }
}

/// Add the faces inside the rim as triangles, with their neighbours.
void add_triangles(Delaunay& delaunay, const SharedTask& task, Triangulation& result) {
    const auto is_inside = [](Delaunay::Face_handle face) { return face->info().depth % 2 != 0; };
    for (const Delaunay::Face_handle face : delaunay.finite_face_handles()) {
        task.check();
        if (!is_inside(face)) continue;
        face->info().triangle = TriangleIndex(result.triangles.size());
        result.triangles.push_back(
            {face->vertex(0)->info().point, face->vertex(1)->info().point, face->vertex(2)->info().point});
    }
    result.neighbors.reserve(result.triangles.size());
    for (const Delaunay::Face_handle face : delaunay.finite_face_handles()) {
        task.check();
        if (!is_inside(face)) continue;
        const auto behind = [&](int i) {
            return face->is_constrained(i) ? TriangleIndex() : face->neighbor(i)->info().triangle;
        };
        result.neighbors.push_back({behind(0), behind(1), behind(2)});
    }
}

}  // namespace

geometry::Point2 circumcenter(geometry::Point2 a, geometry::Point2 b, geometry::Point2 c) {
    const geometry::Point2 u = b - a;
    const geometry::Point2 v = c - a;
    const double scale = 0.5 / cross(u, v);
    const double uu = dot(u, u);
    const double vv = dot(v, v);
    return a + geometry::Point2{scale * (v.y * uu - u.y * vv), scale * (u.x * vv - v.x * uu)};
}

Triangulation triangulate(const Rim& rim, const std::vector<geometry::Point2>& sites,
                          const SharedTask& task) {
    Triangulation result;
    Delaunay delaunay;
    result.rim_count = static_cast<int>(rim.points.size());
    base::IndexVector<PointIndex, Delaunay::Vertex_handle> handles;
    const auto insert = [&](geometry::Point2 point) {
        task.check();
        // Start the search at the last vertex, because the next point is usually near it.
        const auto near = handles.empty() ? Delaunay::Face_handle() : handles.back()->face();
        const Delaunay::Vertex_handle vertex = delaunay.insert(Kernel::Point_2(point.x, point.y), near);
        if (!vertex->info().point.is_valid()) vertex->info().point = PointIndex(result.points.size());
        result.points.push_back(point);
        handles.push_back(vertex);
    };
    for (const RimPoint& point : rim.points) insert(point.place);
    for (std::size_t i = 0; i < rim.next.size(); ++i) {
        task.check();
        delaunay.insert_constraint(handles[i], handles[rim.next[i]]);
    }
    for (const geometry::Point2& site : sites) insert(site);
    mark_depths(delaunay, task);
    add_triangles(delaunay, task, result);
    return result;
}

}  // namespace fretwork::tiling::detail
