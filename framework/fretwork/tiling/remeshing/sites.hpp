// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/tiling/detail/work.hpp>
#include <fretwork/tiling/remeshing/rim.hpp>

#include <vector>

namespace fretwork::tiling::detail {

/// Where tiles could be: the inner vertices of an isotropic triangle mesh inside the rim (CGAL's
/// isotropic_remeshing; the rim is protected). `edge` is the length of the triangles' edges, metres: the same
/// everywhere. Looks at every access to a vertex or a face whether to stop.
std::vector<geometry::Point2> remeshed_sites(const Rim& rim, double edge, int iterations, const Work& work);

/// Where tiles could be: the points of a triangular lattice inside the rim. `angle` (rad) turns the lattice.
/// Where sites are to be nearer to each other, points of finer lattices.
std::vector<geometry::Point2> lattice_sites(const Rim& rim, const Spacing& spacing, double angle,
                                            const Work& work);

/// Put a site into every large triangle without one: so a band that is narrower than the lattice gets a row
/// of sites.
void fill_empty_parts(const Rim& rim, const Spacing& spacing, std::vector<geometry::Point2>& sites,
                      const Work& work);

/// Move the sites towards the centroids of their tiles, again and again (Lloyd), with a new constrained
/// Delaunay triangulation each time. Each iteration is a step of the work.
std::vector<geometry::Point2> relax(const Rim& rim, const SizeField& field,
                                    std::vector<geometry::Point2> sites, int iterations, Work& work);

/// Put a site on each edge between two points of the rim that parts tiles, where there is room.
/// Returns whether some were added.
bool bridge_chords(const Rim& rim, const Spacing& spacing, std::vector<geometry::Point2>& sites,
                   const Work& work);

}  // namespace fretwork::tiling::detail
