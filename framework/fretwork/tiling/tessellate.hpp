// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/control.hpp>
#include <fretwork/outlines/outline.hpp>
#include <fretwork/pattern/node_layout.hpp>
#include <fretwork/tiling/painting/painting.hpp>
#include <fretwork/tiling/tessellation.hpp>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace fretwork::tiling {

/// A point of an outline is left out if its distance from the point before it is below this share of the
/// wanted side. The last points are also compared with the first point.
inline constexpr double kNegligibleShare = 1e-6;

/// The treatment of an outline that is narrower than a tile.
enum class Narrow {
    Refine,  ///< make tiles smaller until one tile fits
    /// Make tiles smaller as with Refine, then merge as many as possible: a narrow band gets long tiles.
    Merge,
    /// Throw GeometryError, also if a tiling with the wanted sides has other defects. Tiles around small
    /// holes are made smaller all the same.
    Refuse,
};

/// Options of tessellate().
struct TessellationOptions {
    double edge_length = 0.0;  ///< wanted mean side of the polygons, m, from 1e-9 to 1e6
    /// Smallest length of a side, m, such as the width of the bars that meet at it. 0: no limit.
    double smallest_side = 0.0;
    Narrow narrow = Narrow::Refine;  ///< treatment of places where the outline is narrower than a tile
    int remeshing_iterations = 10;   ///< number of iterations of the isotropic remeshing
    int relaxation_iterations = 40;  ///< number of iterations towards a centroidal tessellation
    /// Number of triangular lattices that are sketched; the best are tried in full. With smaller tiles at
    /// some places, half as many are sketched, and at most two if the outline has holes and needs more than
    /// about 3,000 tiles. 0: only the remeshed triangles are tried.
    int lattice_angles = 12;
    /// The angle of the rows of tiles to the x axis, rad. Only one lattice at this angle is tried, and no
    /// remeshing. Angles repeat after 60 degrees. None: the most regular of several tilings.
    std::optional<double> angle{};
    /// Number of threads; 0: one for each processor; the result does not depend on the number.
    int threads = 0;
    /// Progress and stop. The stop is checked in all long loops. Some calls of CGAL and of the standard
    /// library process the whole outline without a check. README.md states the time from a request to the
    /// return.
    base::Control control{};
    /// Throws InputError if `edge_length`, `angle`, or a number of iterations or lattices is invalid.
    void validate() const;
};

/// The measures of a tiling. The statistics of sides count each side once, whether one or two tiles have it.
struct TessellationReport {
    double mean_side = 0.0;            ///< mean length of the sides, m
    double sd_side = 0.0;              ///< standard deviation of the lengths of the sides, m
    double smallest_side = 0.0;        ///< length of the shortest side, m
    double largest_side = 0.0;         ///< length of the longest side, m
    double smallest_angle = 0.0;       ///< smallest angle of a tile, rad
    double hexagon_share = 0.0;        ///< share of hexagons among the tiles
    double inner_hexagon_share = 0.0;  ///< share of hexagons among the tiles without a vertex on the outline;
                                       ///< 0 without such tiles
    double covered_share = 0.0;        ///< share of the outline's area that tiles cover
    double outside_share = 0.0;        ///< area of the tiles outside the outline, over the outline's area
    /// Share of the tiles with a reduced wanted side: near narrow places, small holes and mended defects.
    double refined_share = 0.0;
    int tiles = 0;        ///< number of tiles
    int inner_tiles = 0;  ///< number of tiles without a vertex on the outline
    /// The number of points of the outline that were left out; see kNegligibleShare.
    int negligible_points = 0;
    std::string start;  ///< source of the tiling: "remeshing", "lattice at 15 deg" or "mesh"
};

/// The outcome of `tessellate`.
struct TessellationResult {
    Tessellation tessellation;  ///< the tiles
    TessellationReport report;  ///< measures of the tiles
};

/// Cover an outline with convex polygons that share whole sides: the dual of a triangulation, relaxed towards
/// a centroidal tessellation. Paper, Section 6.
///
/// The triangles come from isotropic remeshing and from triangular lattices at several angles. Among the
/// tilings with a mean side within 1 % of the wanted side, the most regular is chosen; if there are none, the
/// tiling with the nearest mean side. A tiling is regular if most tiles inside are hexagons, most tiles at
/// the rim are pentagons or hexagons, and sides and areas are nearly equal. Where the outline is narrower
/// than a tile, tiles are smaller (options.narrow), and sharp tips are cut off. The paper names another
/// remesher and does not describe the closure at the rim. Here, sides between tiles end on the outline. A
/// tile's side at the rim is the chord between two such ends, or meets a corner of the outline. Then every
/// tile is regularized, and sides are made even.
///
/// The tiling has the outline's topology, by an exact test. The tiles cover at least 98 % of the outline's
/// area. No side is shorter than a quarter of the mean side of its tiles, or of `edge_length` if that is
/// less. No angle is below 25 degrees. docs/concepts/tiling.md lists all guarantees.
///
/// Throws GeometryError with a place if no such tiling is found; the message states a smaller side that works
/// if one of at most five tried sides does. Throws GeometryError also if two stretches of the outline are
/// nearer to each other than a ten-thousandth of `edge_length` (a needle, a slit), or if the outline is not
/// valid without its negligible points (kNegligibleShare). Throws InputError if an option is invalid, if more
/// than 100,000 tiles would be needed, if holes make tiles so small that more than 20,000 would be needed, or
/// if the outline lies so far from the origin that its coordinates are too coarse. Throws base::Stopped.
/// Needles, slits, size and position are checked before any triangle is made. The
/// result is deterministic.
TessellationResult tessellate(const outlines::Outline& outline, const pattern::NodeLayout& layout,
                              const TessellationOptions& options);

/// Tile several separate outlines as one tessellation. Tiles, vertices and interface nodes are numbered part
/// by part. Parts share no node, so each part needs its own supports.
///
/// The report covers all parts. Its means and shares of tiles are weighted by the numbers of tiles; its
/// `start` is that of the first part. Throws as `tessellate`; a GeometryError names the part if there are
/// several. Throws InputError if there is no part.
TessellationResult tessellate_parts(const std::vector<outlines::Outline>& parts,
                                    const pattern::NodeLayout& layout, const TessellationOptions& options);

/// Read a flat OBJ, PLY or OFF mesh and take its faces as tiles, so that a tessellation by another program
/// can be painted. Paper, Section 6. Tiles, vertices and interface nodes get new numbers. The faces may also
/// all run clockwise (a mesh seen from below).
///
/// Throws as outlines::read_flat_mesh(). Throws GeometryError that names a face if the face is not convex up
/// to rounding (geometry::is_nearly_convex()), or does not share whole sides with its neighbours (a vertex in
/// the middle of a side, an overlap, two faces on the same side of an edge). Throws GeometryError also if the
/// faces are not connected by sides, or if the rim of the mesh touches itself in a vertex.
TessellationResult read_mesh_tessellation(const std::filesystem::path& path,
                                          const pattern::NodeLayout& layout);

}  // namespace fretwork::tiling
