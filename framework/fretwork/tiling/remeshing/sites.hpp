// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/tiling/detail/shared_task.hpp>
#include <fretwork/tiling/remeshing/rim.hpp>

#include <vector>

namespace fretwork::tiling::detail {

/// Sites, the approximate centers of tiles: the inner vertices of an isotropic triangle mesh inside the rim
/// (CGAL's isotropic_remeshing; the rim is protected), except those near the rim. `edge` is the wanted length
/// of the triangles' edges, m. Every read access to a vertex or a face checks for a stop. All functions here
/// throw base::Stopped.
std::vector<geometry::Point2> remeshed_sites(const Rim& rim, double edge, int iterations,
                                             const SharedTask& task);

/// Sites on a triangular lattice inside the rim, rotated by `angle` (rad). Where the wanted distance of sites
/// is smaller, the sites lie on finer lattices, each 0.75 times as wide as the one before.
std::vector<geometry::Point2> lattice_sites(const Rim& rim, const Spacing& spacing, double angle,
                                            const SharedTask& task);

/// Put a site at the center of every large circle without sites, if the center lies inside, so that a band
/// narrower than the lattice gets a row of sites. Repeat this up to eight times.
void fill_empty_parts(const Rim& rim, const Spacing& spacing, std::vector<geometry::Point2>& sites,
                      const SharedTask& task);

/// Move the sites repeatedly to the centroids of their tiles (Lloyd), weighted with the wanted density, with
/// a new constrained Delaunay triangulation each time. Each iteration is one step of progress.
std::vector<geometry::Point2> relax(const Rim& rim, const SizeField& field,
                                    std::vector<geometry::Point2> sites, int iterations, SharedTask& task);

/// Put a site in the middle of each chord (see chords_of()), if there is room for a site. Returns true if
/// sites were added.
bool bridge_chords(const Rim& rim, const Spacing& spacing, std::vector<geometry::Point2>& sites,
                   const SharedTask& task);

}  // namespace fretwork::tiling::detail
