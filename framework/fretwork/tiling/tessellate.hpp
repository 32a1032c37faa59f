// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/pattern/node_layout.hpp>
#include <fretwork/tiling/outline.hpp>
#include <fretwork/tiling/painting.hpp>
#include <fretwork/tiling/tessellation.hpp>

namespace fretwork::tiling {

struct TessellationOptions {
    double edge_length = 0.0;  ///< m; wanted mean side of the polygons, such as the setting's tile side
    int remeshing_iterations = 10;
    int relaxation_iterations = 50;  ///< towards a centroidal tessellation
    /// Throws InputError if a value makes no sense.
    void validate() const;
};

/// What the tiling came out as.
struct TessellationReport {
    double mean_side = 0.0;      ///< m
    double sd_side = 0.0;        ///< m
    double hexagon_share = 0.0;  ///< of the tiles
    double covered_share = 0.0;  ///< area of the tiles over area of the outline
    int tiles = 0;
};

/// What `tessellate` gives.
struct TessellationResult {
    Tessellation tessellation;
    TessellationReport report;
};

/// Cover an outline with polygons: constrained triangulation and isotropic remeshing, relaxed, then the dual.
/// Paper, Section 6. Throws GeometryError if the outline is too small for one tile. Deterministic.
TessellationResult tessellate(const Outline& outline, const pattern::NodeLayout& layout,
                              const TessellationOptions& options);

}  // namespace fretwork::tiling
