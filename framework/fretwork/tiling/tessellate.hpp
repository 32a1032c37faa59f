// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/control.hpp>
#include <fretwork/outlines/outline.hpp>
#include <fretwork/pattern/node_layout.hpp>
#include <fretwork/tiling/painting/painting.hpp>
#include <fretwork/tiling/tessellation.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace fretwork::tiling {

/// A point of an outline is left out if its distance from the previous point is below this share of the
/// wanted side.
inline constexpr double kNegligibleShare = 1e-6;

/// The treatment of an outline that is narrower than a tile.
enum class Narrow {
    Refine,  ///< make tiles smaller until one fits
    Merge,   ///< as Refine, and then merge as many tiles as possible: a narrow band gets long tiles
    Refuse,  ///< throw GeometryError, also if smaller tiles are needed for another reason
};

/// Options of tessellate().
struct TessellationOptions {
    double edge_length = 0.0;  ///< m; wanted mean side of the polygons, from 1e-9 to 1e6
    /// m; lower limit of all sides, such as the width of the bars that meet there. 0: no limit.
    double smallest_side = 0.0;
    Narrow narrow = Narrow::Refine;  ///< what to do where the outline is narrower than a tile
    int remeshing_iterations = 10;   ///< of the isotropic remeshing
    int relaxation_iterations = 40;  ///< iterations towards a centroidal tessellation
    int lattice_angles = 12;  ///< number of triangular lattices to try in addition to the remeshed triangles
    int threads = 0;          ///< 0: one for each processor; the result does not depend on it
    /// Checked in every loop. Some calls of CGAL and of the standard library process the whole outline
    /// without a check; README.md states their times.
    base::Control control{};
    /// Throws InputError if a value is invalid.
    void validate() const;
};

/// The measures of a tiling. The statistics of sides count each side once, whether it belongs to one tile or
/// two.
struct TessellationReport {
    double mean_side = 0.0;            ///< m
    double sd_side = 0.0;              ///< m
    double smallest_side = 0.0;        ///< m
    double smallest_angle = 0.0;       ///< rad; smallest angle of a tile
    double hexagon_share = 0.0;        ///< share of hexagons among the tiles
    double inner_hexagon_share = 0.0;  ///< share of hexagons among the tiles without a vertex on the outline;
                                       ///< 0 without such tiles
    double covered_share = 0.0;        ///< share of the outline's area that tiles cover
    double outside_share = 0.0;        ///< area of the tiles outside the outline, over the outline's area
    double refined_share = 0.0;  ///< share of the tiles that are smaller because the outline is narrow nearby
    int tiles = 0;               ///< how many
    /// The number of points of the outline that were left out; see kNegligibleShare.
    int negligible_points = 0;
    std::string start;  ///< "remeshing", or "lattice at 15 deg"
};

/// The outcome of `tessellate`.
struct TessellationResult {
    Tessellation tessellation;  ///< the tiles
    TessellationReport report;  ///< how regular they are
};

/// Cover an outline with convex polygons that share whole sides: the dual of a triangulation, relaxed towards
/// a centroidal tessellation. Paper, Section 6.
///
/// The triangles come from isotropic remeshing and from triangular lattices at several angles. Among the
/// tilings whose mean side is within 1 % of the wanted one (or else as near as possible), the most regular is
/// chosen. It has the most hexagons inside, pentagons and hexagons at the rim, equal sides, and equal areas.
/// Where the outline is narrower than a tile, tiles are smaller (options.narrow), and sharp tips are cut off.
/// The paper names another remesher and does not describe the closure at the rim. Here, sides between tiles
/// end on the outline. A tile's side at the rim is the chord between two such ends, or meets a corner of the
/// outline. At the end every tile is regularized.
///
/// The tiling has the outline's topology, decided exactly, covers at least 98 % of it, has no side shorter
/// than a quarter of the wanted side there, and no angle below 25 degrees. README.md lists all guarantees.
///
/// Throws GeometryError with a place if no such tiling is found; the message names a smaller side that was
/// tried and works. Throws GeometryError also if two stretches of the outline are nearer to each other than a
/// ten-thousandth of `edge_length` (a needle, a slit). Throws InputError if more than 100,000 tiles would be
/// needed, or if the outline lies so far from the origin that its coordinates are too coarse. Throws
/// base::Stopped. Needles, slits, size and position are checked before any triangle is made. Deterministic.
TessellationResult tessellate(const outlines::Outline& outline, const pattern::NodeLayout& layout,
                              const TessellationOptions& options);

/// Tile several separate outlines as one tessellation: first the tiles, vertices and interface nodes of the
/// first part, then those of the next. Parts share nothing, so each needs its own supports.
///
/// The report covers all parts, with the `start` of the first. Throws as `tessellate`, with the part's number
/// if there are several.
TessellationResult tessellate_parts(const std::vector<outlines::Outline>& parts,
                                    const pattern::NodeLayout& layout, const TessellationOptions& options);

/// Read a flat OBJ, PLY or OFF mesh and take its faces as tiles without a change, so that a tessellation by
/// another program can be painted. Paper, Section 6. Tiles, vertices and interface nodes get new numbers. The
/// faces may also all run clockwise (a mesh seen from below).
///
/// Throws InputError or GeometryError that names the face if it is not convex, if it does not share whole
/// sides with its neighbours (a vertex in the middle of a side, an overlap, two faces on the same side of a
/// side), if the faces are not connected by sides, or if faces touch elsewhere in a single vertex.
TessellationResult read_mesh_tessellation(const std::filesystem::path& path,
                                          const pattern::NodeLayout& layout);

}  // namespace fretwork::tiling
