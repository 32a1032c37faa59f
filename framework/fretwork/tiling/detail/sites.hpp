// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/tiling/detail/rim.hpp>

#include <vector>

namespace fretwork::tiling::detail {

/// Where tiles could be: the inner vertices of an isotropic triangle mesh inside the rim (CGAL's
/// isotropic_remeshing; the rim is protected). `edge` is the length of the triangles' edges, metres.
std::vector<pattern::Point2> remeshed_sites(const Rim& rim, double edge, int iterations);

/// Where tiles could be: the points of a triangular lattice inside the rim. `angle` (rad) turns the lattice.
std::vector<pattern::Point2> lattice_sites(const Rim& rim, double edge, double angle);

/// Move the sites towards the centroids of their tiles, again and again (Lloyd), with a new constrained
/// Delaunay triangulation each time.
std::vector<pattern::Point2> relax(const Rim& rim, std::vector<pattern::Point2> sites, int iterations);

}  // namespace fretwork::tiling::detail
