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

/// The faces between the sides of lines, with exact crossings (CGAL's arrangements).
namespace fretwork::outlines::detail {

/// The mark of a face, for the algorithms that use the map.
struct FaceMark {
    bool is_filled = false;
    int part = -1;    ///< faces of one part are connected by sides
    int number = -1;  ///< index in the order of visit_faces(); -1: not visited
};

struct AppendSides {
    std::vector<int> operator()(std::vector<int> a, const std::vector<int>& b) const {
        a.insert(a.end(), b.begin(), b.end());
        return a;
    }
};

using ExactKernel = CGAL::Exact_predicates_exact_constructions_kernel;
/// Each edge stores the indices of the sides that run along it.
using SideTraits =
    CGAL::Arr_curve_data_traits_2<CGAL::Arr_segment_traits_2<ExactKernel>, std::vector<int>, AppendSides>;
using PlanarMap = CGAL::Arrangement_2<SideTraits, CGAL::Arr_face_extended_dcel<SideTraits, FaceMark>>;

/// A polyline of a map, open or closed.
struct MapLine {
    const geometry::Polygon* points;
    enum class Ends { Open, Closed } ends = Ends::Closed;
};

/// A map of lines, and the line to which each side belongs.
struct LineMap {
    struct Side {
        int line = 0;
        /// +1: the side runs from left to right, or upwards if it is upright; -1: the other way
        int direction = 0;
    };
    PlanarMap map;
    std::vector<Side> sides;
};

/// Make the map of lines. Sides of length zero are left out. Throws GeometryError if sides cross, or come
/// near each other, far too often.
LineMap make_line_map(const std::vector<MapLine>& lines);

/// Callbacks of visit_faces(), which goes from face to face, also back to faces that it has left. On the way,
/// `cross` is called for each side that is crossed, with its line and the change of that line's winding
/// number. At each face, `look` is called once.
struct WindingVisitor {
    std::function<void(int line, int change)> cross;
    std::function<void(PlanarMap::Face_handle)> look;
};
void visit_faces(LineMap& lines, const WindingVisitor& visitor);

/// The halfedges around a face and around its holes.
std::vector<PlanarMap::Halfedge_handle> halfedges_of(PlanarMap::Face_handle face);

inline geometry::Point2 place_of(PlanarMap::Vertex_const_handle vertex) {
    return {CGAL::to_double(vertex->point().x()), CGAL::to_double(vertex->point().y())};
}

}  // namespace fretwork::outlines::detail
