// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/fabrication/detail/length_text.hpp>
#include <fretwork/fabrication/detail/triangulation.hpp>
#include <fretwork/geometry/plane.hpp>

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <deque>

namespace fretwork::fabrication::detail {
namespace {

using geometry::Point2;

struct Depth {
    int lines = -1;  ///< 1: a face is inside; 0: outside; -1: not known
};

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Vertices = CGAL::Triangulation_vertex_base_with_info_2<int, Kernel>;
using Faces = CGAL::Triangulation_face_base_with_info_2<Depth, Kernel,
                                                        CGAL::Constrained_triangulation_face_base_2<Kernel>>;
using Triangulation =
    CGAL::Constrained_Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<Vertices, Faces>,
                                               CGAL::No_constraint_intersection_requiring_constructions_tag>;

[[noreturn]] void fail(const Point2& place) {
    throw base::GeometryError(
        "the outline touches itself at " + place_text(place) +
        ": the solid would be connected only along an edge; change a width or a fillet");
}

/// Insert all corners at once, which is faster. Returns their vertices in the order of the corners.
std::vector<Triangulation::Vertex_handle> insert_corners(Triangulation& triangulation,
                                                         std::span<const geometry::Polygon> lines) {
    std::vector<std::pair<Kernel::Point_2, int>> corners;
    for (const geometry::Polygon& line : lines)
        for (const Point2& point : line)
            corners.emplace_back(Kernel::Point_2(point.x, point.y), static_cast<int>(corners.size()));
    triangulation.insert(corners.begin(), corners.end());
    std::vector<Triangulation::Vertex_handle> handles(corners.size());
    for (auto vertex = triangulation.finite_vertices_begin(); vertex != triangulation.finite_vertices_end();
         ++vertex)
        handles[vertex->info()] = vertex;
    for (std::size_t i = 0; i < handles.size(); ++i) {
        if (handles[i] == Triangulation::Vertex_handle()) fail({corners[i].first.x(), corners[i].first.y()});
    }
    return handles;
}

void insert_lines(Triangulation& triangulation, std::span<const geometry::Polygon> lines) {
    const auto handles = insert_corners(triangulation, lines);
    std::size_t first = 0;
    for (const geometry::Polygon& line : lines) {
        for (std::size_t i = 0; i < line.size(); ++i) {
            const auto from = handles[first + i];
            const auto to = handles[first + (i + 1) % line.size()];
            try {
                triangulation.insert_constraint(from, to);
            } catch (const Triangulation::Intersection_of_constraints_exception&) {
                fail(line[i]);
            }
            Triangulation::Face_handle face;
            int index = 0;
            if (!triangulation.is_edge(from, to, face, index)) fail(line[i]);
        }
        first += line.size();
    }
}

/// Mark every face as inside or outside the lines.
void mark_depths(Triangulation& triangulation) {
    std::deque<Triangulation::Face_handle> next = {triangulation.infinite_face()};
    next.front()->info().lines = 0;
    while (!next.empty()) {
        const auto face = next.front();
        next.pop_front();
        for (int i = 0; i < 3; ++i) {
            const auto neighbor = face->neighbor(i);
            if (neighbor->info().lines >= 0) continue;
            const bool across = triangulation.is_constrained({face, i});
            neighbor->info().lines = face->info().lines ^ (across ? 1 : 0);
            next.push_back(neighbor);
        }
    }
}

}  // namespace

std::vector<std::array<int, 3>> triangulated(std::span<const geometry::Polygon> lines) {
    Triangulation triangulation;
    insert_lines(triangulation, lines);
    mark_depths(triangulation);
    std::vector<std::array<int, 3>> triangles;
    for (auto face = triangulation.finite_faces_begin(); face != triangulation.finite_faces_end(); ++face) {
        if (face->info().lines % 2 == 0) continue;
        triangles.push_back({face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()});
    }
    return triangles;
}

}  // namespace fretwork::fabrication::detail
