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

/// Points of an outline nearer than this share of the wanted side to the point before them are left out.
inline constexpr double kNegligibleShare = 1e-6;

/// The treatment of an outline that is narrower than a tile.
enum class Narrow {
    Refine,  ///< smaller tiles, as many as it takes for one to fit
    Merge,   ///< the same, and then as few as go together: a narrow band gets long tiles
    Refuse,  ///< GeometryError; so is whatever else needs smaller tiles somewhere
};

struct TessellationOptions {
    double edge_length = 0.0;  ///< m; wanted mean side of the polygons, from 1e-9 to 1e6
    /// m; no side may be shorter, such as the width of the bars that are to meet there. 0: no limit.
    double smallest_side = 0.0;
    Narrow narrow = Narrow::Refine;
    int remeshing_iterations = 10;
    int relaxation_iterations = 40;  ///< towards a centroidal tessellation
    int lattice_angles = 12;  ///< number of triangular lattices that are tried beside the remeshed triangles
    int threads = 0;          ///< 0: all there are; the result does not depend on it
    /// Looked at in every loop; but some calls of CGAL and of the standard library work on the whole outline
    /// without a look: README.md says how long that takes.
    base::Control control{};
    /// Throws InputError if a value is invalid.
    void validate() const;
};

/// The measures of a tiling. Each side counts once in the statistics of sides, whether one tile or two have
/// it.
struct TessellationReport {
    double mean_side = 0.0;            ///< m
    double sd_side = 0.0;              ///< m
    double smallest_side = 0.0;        ///< m
    double smallest_angle = 0.0;       ///< rad, of a tile
    double hexagon_share = 0.0;        ///< of the tiles
    double inner_hexagon_share = 0.0;  ///< of the tiles with no vertex on the outline; 0 if there are none
    double covered_share = 0.0;        ///< of the outline's area
    double outside_share = 0.0;  ///< area of the tiles that is outside of the outline, over the outline's
    double refined_share = 0.0;  ///< of the tiles that are wanted smaller, since the outline is narrow nearby
    int tiles = 0;
    /// Points of the outline that were left out, see kNegligibleShare.
    int negligible_points = 0;
    std::string start;  ///< "remeshing", or "lattice at 15 deg"
};

/// The outcome of `tessellate`.
struct TessellationResult {
    Tessellation tessellation;
    TessellationReport report;
};

/// Cover an outline with convex polygons that share whole sides: the dual of a triangulation, relaxed towards
/// a centroidal tessellation. Paper, Section 6.
///
/// The triangles come from isotropic remeshing, and from triangular lattices at several angles; of the
/// tilings whose mean side is the wanted one within 1 % (or as nearly as there is one), the most regular is
/// taken: most hexagons inside, pentagons and hexagons at the rim, equal sides, equal areas. Where the
/// outline is narrower than a tile, the tiles are smaller (options.narrow), and sharp tips lose their ends.
/// Deviation from the paper: it names another remesher, and does not say how the rim is closed. Here sides
/// between tiles end on the outline, and a tile's side at the rim is the chord between two such ends, or
/// meets the outline's corner; then every tile is regularized.
///
/// The tiling has the outline's topology, decided exactly, covers at least 98 % of it, and has no side
/// shorter than a quarter of the side wanted there and no angle below 25 degrees: README.md has the laws.
///
/// Throws GeometryError with a place if no such tiling is found, and names a smaller side that works (it is
/// tried), or if two parts of the outline are nearer to each other than a ten-thousandth of `edge_length` (a
/// needle, a slit); InputError if it would need more than 100,000 tiles or lies so far from the origin that
/// its coordinates are too coarse; base::Stopped. Needles, slits, size and place are looked at before any
/// triangle is made. Deterministic.
TessellationResult tessellate(const outlines::Outline& outline, const pattern::NodeLayout& layout,
                              const TessellationOptions& options);

/// Tile several outlines that lie apart as one tessellation: the tiles, vertices and interface nodes of the
/// first part, then those of the next. Parts share nothing, so each needs its own supports.
///
/// The report is that of the whole: of the outline as `tessellate` says, with the first part's `start`.
/// Throws what `tessellate` throws, with the part's number if there are several.
TessellationResult tessellate_parts(const std::vector<outlines::Outline>& parts,
                                    const pattern::NodeLayout& layout, const TessellationOptions& options);

/// Read a flat OBJ, PLY or OFF mesh and take its faces as tiles, as they are; so any tessellation by another
/// program can be painted. Paper, Section 6. Tiles, vertices and interface nodes get new numbers. Faces may
/// all run clockwise (a mesh that is seen from below).
///
/// Throws InputError or GeometryError that names the face: if it is not convex, or does not share whole sides
/// with its neighbours (a vertex on the middle of a side, an overlap, a second face on the same side of a
/// side), or if the faces are not connected by sides, or touch elsewhere in a single vertex.
TessellationResult read_mesh_tessellation(const std::filesystem::path& path,
                                          const pattern::NodeLayout& layout);

}  // namespace fretwork::tiling
