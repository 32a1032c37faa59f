// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/geometry/plane.hpp>
#include <fretwork/tiling/remeshing/inside.hpp>
#include <fretwork/tiling/remeshing/sites.hpp>
#include <fretwork/tiling/remeshing/triangulation.hpp>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <iterator>

namespace fretwork::tiling::detail {
namespace {

using geometry::Point2;

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
namespace pmp = CGAL::Polygon_mesh_processing;

/// The distance from the rim below which a site would give a needle.
constexpr double kMargin = 0.2;  // share of the edge
/// The largest side of the rim. The remeshing splits every edge above 4/3 of the wanted edge, but must not
/// split the rim.
constexpr double kLongestOfRim = 1.3;  // share of the edge

/// The property map of a mesh's vertices for isotropic_remeshing. Each read access checks for a stop.
struct WatchedPlaces {
    using Places = Mesh::Property_map<Mesh::Vertex_index, Kernel::Point_3>;
    using key_type = Mesh::Vertex_index;
    using value_type = Kernel::Point_3;
    using reference = Places::reference;
    using category = boost::lvalue_property_map_tag;
    Places places;
    const SharedTask* task;

    friend reference get(const WatchedPlaces& map, key_type vertex) {
        map.task->check();
        return get(map.places, vertex);
    }
    friend void put(const WatchedPlaces& map, key_type vertex, const value_type& place) {
        put(map.places, vertex, place);
    }
    reference operator[](key_type vertex) const { return get(*this, vertex); }
};

/// The property map of the patches of faces, with a single patch. Each read access checks for a stop, also
/// while only edges are flipped.
struct OnePatch {
    using key_type = Mesh::Face_index;
    using value_type = std::size_t;
    using reference = std::size_t;
    using category = boost::read_write_property_map_tag;
    const SharedTask* task;

    friend std::size_t get(const OnePatch& map, key_type) {
        map.task->check();
        return 0;
    }
    friend void put(const OnePatch&, key_type, std::size_t) {}
};

Mesh surface_mesh(const Triangulation& triangulation, const SharedTask& task) {
    Mesh mesh;
    std::vector<Mesh::Vertex_index> vertices;
    for (const Point2& point : triangulation.points) {
        vertices.push_back(mesh.add_vertex(Kernel::Point_3(point.x, point.y, 0)));
    }
    const auto vertex = [&](int point) { return vertices[point]; };
    for (const auto& [a, b, c] : triangulation.triangles) {
        task.check();
        mesh.add_face(vertex(a), vertex(b), vertex(c));
    }
    return mesh;
}

}  // namespace

std::vector<Point2> remeshed_sites(const Rim& rim, double edge, int iterations, const SharedTask& task) {
    Mesh mesh = surface_mesh(triangulate(rim, {}, task), task);
    std::vector<Mesh::Edge_index> border;
    std::ranges::copy_if(mesh.edges(), std::back_inserter(border),
                         [&](Mesh::Edge_index e) { return mesh.is_border(e); });
    pmp::split_long_edges(border, kLongestOfRim * edge, mesh,
                          CGAL::parameters::vertex_point_map(WatchedPlaces{mesh.points(), &task}));
    auto is_protected = mesh.add_property_map<Mesh::Edge_index, bool>("e:protected", false).first;
    for (const Mesh::Edge_index e : mesh.edges()) is_protected[e] = mesh.is_border(e);
    pmp::isotropic_remeshing(mesh.faces(), edge, mesh,
                             CGAL::parameters::number_of_iterations(static_cast<unsigned>(iterations))
                                 .vertex_point_map(WatchedPlaces{mesh.points(), &task})
                                 .face_patch_map(OnePatch{&task})
                                 .edge_is_constrained_map(is_protected)
                                 .protect_constraints(true));
    const InsideTest is_inside(rim, kMargin * edge, task.control());
    std::vector<Point2> sites;
    for (const Mesh::Vertex_index v : mesh.vertices()) {
        task.check();
        const Point2 site{mesh.point(v).x(), mesh.point(v).y()};
        if (!mesh.is_border(v) && is_inside(site, kMargin * edge)) sites.push_back(site);
    }
    return sites;
}

}  // namespace fretwork::tiling::detail
