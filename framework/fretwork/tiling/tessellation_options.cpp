// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/geometry/internal/message_text.hpp>
#include <fretwork/tiling/tessellate.hpp>

#include <cmath>

namespace fretwork::tiling {
namespace {

constexpr double kSmallestEdge = 1e-9;  // m; products of such lengths do not underflow
constexpr double kLargestEdge = 1e6;    // m

}  // namespace

void TessellationOptions::validate() const {
    if (!(edge_length >= kSmallestEdge) || !(edge_length <= kLargestEdge))
        throw base::InputError("the edge length of a tessellation is " + geometry::metres(edge_length) +
                               ", where a length from " + geometry::metres(kSmallestEdge) + " to " +
                               geometry::metres(kLargestEdge) + " is needed");
    if (remeshing_iterations < 1 || relaxation_iterations < 0 || lattice_angles < 0)
        throw base::InputError(
            "a tessellation needs at least one iteration of remeshing, and no number below zero");
    if (angle && !std::isfinite(*angle))
        throw base::InputError(
            "the angle of a tessellation's rows is not a number, where radians are needed");
}

}  // namespace fretwork::tiling
