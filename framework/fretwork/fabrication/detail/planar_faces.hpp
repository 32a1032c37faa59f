// SPDX-License-Identifier: GPL-3.0-or-later
// The regions into which the lines of bars cut the plane.
#pragma once

#include <fretwork/fabrication/bar_plan.hpp>

#include <vector>

namespace fretwork::fabrication::detail {

/// A closed walk along bars with the region on its left; a bar with the region on both sides comes twice.
using Walk = geometry::Polygon;

struct Face {
    Walk outer;                 ///< counterclockwise; empty: the unbounded region
    std::vector<Walk> islands;  ///< clockwise around connected bars that lie in the region
};

/// All regions; the last region is the unbounded one.
std::vector<Face> planar_faces(const BarPlan& plan);

}  // namespace fretwork::fabrication::detail
