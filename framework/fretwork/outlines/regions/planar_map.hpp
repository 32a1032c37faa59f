// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/geometry/polygon.hpp>

#include <CGAL/Arr_curve_data_traits_2.h>
#include <CGAL/Arr_extended_dcel.h>
#include <CGAL/Arr_segment_traits_2.h>
#include <CGAL/Arrangement_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include <functional>
#include <vector>

/// The faces into which the sides of polygons cut the plane, with exact crossings (CGAL's arrangements).
namespace fretwork::outlines::detail {

/// A face's own mark; what it means is its user's business.
struct FaceMark {
    bool is_filled = false;
    int part = -1;    ///< faces of one part are connected by sides
    int number = -1;  ///< in the order of the map
};

struct AppendSides {
    std::vector<int> operator()(std::vector<int> a, const std::vector<int>& b) const {
        a.insert(a.end(), b.begin(), b.end());
        return a;
    }
};

using ExactKernel = CGAL::Exact_predicates_exact_constructions_kernel;
/// Each edge knows the sides (by number) that run along it.
using SideTraits =
    CGAL::Arr_curve_data_traits_2<CGAL::Arr_segment_traits_2<ExactKernel>, std::vector<int>, AppendSides>;
using PlanarMap = CGAL::Arrangement_2<SideTraits, CGAL::Arr_face_extended_dcel<SideTraits, FaceMark>>;

/// A polyline of a map: closed or not.
struct MapLine {
    const geometry::Polygon* points;
    enum class Ends { Open, Closed } ends = Ends::Closed;
};

/// A map of lines, and whose each side is.
struct LineMap {
    struct Side {
        int line = 0;
        int direction = 0;  ///< +1: from left to right, or upwards if upright
    };
    PlanarMap map;
    std::vector<Side> sides;
};

/// Sides without length are left out. Throws GeometryError if far too many cross.
LineMap make_line_map(const std::vector<MapLine>& lines);

/// How often each line winds around the faces, one face after the other: `look` is called once for each face,
/// and `cross` before it for the lines whose winding number changes on the way to that face.
struct WindingVisitor {
    std::function<void(int line, int change)> cross;
    std::function<void(PlanarMap::Face_handle)> look;
};
void visit_faces(LineMap& lines, const WindingVisitor& visitor);

/// The halfedges around a face, its holes' included.
std::vector<PlanarMap::Halfedge_handle> halfedges_of(PlanarMap::Face_handle face);

inline geometry::Point2 place_of(PlanarMap::Vertex_const_handle vertex) {
    return {CGAL::to_double(vertex->point().x()), CGAL::to_double(vertex->point().y())};
}

}  // namespace fretwork::outlines::detail
