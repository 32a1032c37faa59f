// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/tiling/detail/dual.hpp>
#include <fretwork/tiling/detail/inside.hpp>
#include <fretwork/tiling/detail/plane.hpp>
#include <fretwork/tiling/detail/sites.hpp>
#include <fretwork/tiling/detail/triangulation.hpp>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <CGAL/Surface_mesh.h>

#include <numbers>

namespace fretwork::tiling::detail {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
namespace pmp = CGAL::Polygon_mesh_processing;

/// Sites nearer to the rim than this make needles.
constexpr double kMargin = 0.2;  // of the edge
/// Half a tile's width: a tile at the rim then is about as large as one inside.
constexpr double kLatticeMargin = 0.45;  // of the edge

/// The places of a mesh's vertices, as isotropic_remeshing reads and writes them. Each access looks whether
/// to stop.
struct WatchedPlaces {
    using Places = Mesh::Property_map<Mesh::Vertex_index, Kernel::Point_3>;
    using key_type = Mesh::Vertex_index;
    using value_type = Kernel::Point_3;
    using reference = Places::reference;
    using category = boost::lvalue_property_map_tag;
    Places places;
    const Work* work;

    friend reference get(const WatchedPlaces& map, key_type vertex) {
        map.work->check();
        return get(map.places, vertex);
    }
    friend void put(const WatchedPlaces& map, key_type vertex, const value_type& place) {
        put(map.places, vertex, place);
    }
    reference operator[](key_type vertex) const { return get(*this, vertex); }
};

/// The patch of each face, of which there is one. It looks whether to stop where only edges are flipped.
struct OnePatch {
    using key_type = Mesh::Face_index;
    using value_type = std::size_t;
    using reference = std::size_t;
    using category = boost::read_write_property_map_tag;
    const Work* work;

    friend std::size_t get(const OnePatch& map, key_type) {
        map.work->check();
        return 0;
    }
    friend void put(const OnePatch&, key_type, std::size_t) {}
};

Mesh surface_mesh(const Triangulation& triangulation) {
    Mesh mesh;
    std::vector<Mesh::Vertex_index> vertices;
    for (const Point2& point : triangulation.points) {
        vertices.push_back(mesh.add_vertex(Kernel::Point_3(point.x, point.y, 0)));
    }
    const auto vertex = [&](int point) { return vertices[static_cast<std::size_t>(point)]; };
    for (const auto& [a, b, c] : triangulation.triangles) mesh.add_face(vertex(a), vertex(b), vertex(c));
    return mesh;
}

/// The first and the last of -reach .. reach for which start + k step may lie in the box of these half sizes
/// around the origin: a long, narrow outline has few lattice points in a box that could hold a great many.
std::pair<int, int> steps_within(Point2 start, Point2 step, Point2 half, int reach) {
    double first = -reach;
    double last = reach;
    const auto narrow = [&](double from, double by, double bound) {
        if (std::abs(by) * reach < 1e-9 * bound) return;  // hardly moves: the other direction decides
        const double one = (-bound - from) / by;
        const double other = (bound - from) / by;
        first = std::max(first, std::ceil(std::min(one, other) - 1e-6));
        last = std::min(last, std::floor(std::max(one, other) + 1e-6));
    };
    narrow(start.x, step.x, half.x);
    narrow(start.y, step.y, half.y);
    return {static_cast<int>(first), static_cast<int>(std::max(last, first - 1))};
}

}  // namespace

std::vector<Point2> remeshed_sites(const Rim& rim, double edge, int iterations, const Work& work) {
    Mesh mesh = surface_mesh(triangulate(rim, {}, work));
    auto is_protected = mesh.add_property_map<Mesh::Edge_index, bool>("e:protected", false).first;
    for (const Mesh::Edge_index e : mesh.edges()) is_protected[e] = mesh.is_border(e);
    pmp::isotropic_remeshing(mesh.faces(), edge, mesh,
                             CGAL::parameters::number_of_iterations(static_cast<unsigned>(iterations))
                                 .vertex_point_map(WatchedPlaces{mesh.points(), &work})
                                 .face_patch_map(OnePatch{&work})
                                 .edge_is_constrained_map(is_protected)
                                 .protect_constraints(true));
    const InsideTest is_inside(rim, kMargin * edge);
    std::vector<Point2> sites;
    for (const Mesh::Vertex_index v : mesh.vertices()) {
        work.check();
        const Point2 site{mesh.point(v).x(), mesh.point(v).y()};
        if (!mesh.is_border(v) && is_inside(site)) sites.push_back(site);
    }
    return sites;
}

std::vector<Point2> lattice_sites(const Rim& rim, double edge, double angle, const Work& work) {
    Point2 low = rim.points.front().place;
    Point2 high = low;
    for (const RimPoint& point : rim.points) {
        low = {std::min(low.x, point.place.x), std::min(low.y, point.place.y)};
        high = {std::max(high.x, point.place.x), std::max(high.y, point.place.y)};
    }
    const Point2 middle = between(low, high, 0.5);
    const Point2 along{edge * std::cos(angle), edge * std::sin(angle)};
    const Point2 across{edge * std::cos(angle + std::numbers::pi / 3),
                        edge * std::sin(angle + std::numbers::pi / 3)};
    const Point2 half = 0.5 * (high - low);
    // Rows of a triangular lattice are sqrt(3)/2 apart.
    const int reach = static_cast<int>(std::ceil(distance(low, high) / edge)) + 1;
    const InsideTest is_inside(rim, kLatticeMargin * edge);
    std::vector<Point2> sites;
    for (int row = -reach; row <= reach; ++row) {
        work.check();
        const Point2 start = static_cast<double>(row) * across;
        const auto [first, last] = steps_within(start, along, half, reach);
        for (int column = first; column <= last; ++column) {
            work.check();
            const Point2 site = middle + static_cast<double>(column) * along + start;
            if (is_inside(site)) sites.push_back(site);
        }
    }
    return sites;
}

std::vector<Point2> relax(const Rim& rim, std::vector<Point2> sites, int iterations, Work& work) {
    const InsideTest is_inside(rim, 0.0);
    for (int i = 0; i < iterations; ++i) {
        work.advance(1);
        if (sites.empty()) continue;
        const Dual dual = dual_of(rim, triangulate(rim, sites, work), work);
        for (std::size_t site = 0; site < sites.size(); ++site) {
            work.check();
            const Polygon polygon = polygon_of(dual, site);
            if (polygon.size() < 3) continue;
            const Point2 target = pattern::centroid(polygon);
            if (is_inside(target)) sites[site] = target;
        }
    }
    return sites;
}

}  // namespace fretwork::tiling::detail
