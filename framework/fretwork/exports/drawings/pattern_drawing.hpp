// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/pattern/node_layout.hpp>
#include <fretwork/pattern/pattern.hpp>
#include <fretwork/pattern/rejections.hpp>
#include <fretwork/reduction/calibration/calibration.hpp>

#include <optional>
#include <span>
#include <string>

namespace fretwork::exports {

/// Options of drawings of patterns.
struct PatternDrawingOptions {
    double tile_side = 0.025980762113533160;  ///< side of the polygon, m, as in the paper
    double beam_width = 0.002;                ///< width of the beams, m
    int sides = 6;                            ///< number of sides of the polygon
};

/// A sheet with the layout and its candidate edges, and with patterns as fans with their ids, as in the
/// paper's Fig. 3b and Fig. 2. With up to five columns of cells, text is legible (6 pt) when the sheet is
/// scaled to a journal's column (84 mm); with up to twelve, when it is scaled to a page (177 mm). The sheet
/// states this width (`data-print-width`); larger sheets state none. The same holds for the sheets below.
std::string pattern_sheet_svg(const pattern::NodeLayout& layout, std::span<const pattern::Pattern> patterns,
                              const PatternDrawingOptions& options = {});

/// A sheet with rejected graphs as fans, as in the paper's Fig. 7: one row for each run of rejections by the
/// same filter, the guilty beams in red, and id and reason below each fan.
std::string rejection_sheet_svg(const pattern::NodeLayout& layout,
                                std::span<const pattern::Rejection> rejections,
                                const PatternDrawingOptions& options = {});

/// A pattern and, if there is one, the calibration of a reduced model of beams to it.
struct ReducedPattern {
    pattern::Pattern pattern;  ///< the pattern
    /// Calibration of the reduced model; none: only the pattern is drawn.
    std::optional<reduction::Calibration> calibration{};
};

/// A sheet with patterns and their reduced models side by side, as in the paper's Fig. 8: in the setting's
/// polygon, at true scale, with ids, the twist theta and the objective.
std::string reduced_sheet_svg(const pattern::NodeLayout& layout, std::span<const ReducedPattern> patterns,
                              const reduction::Setting& setting,
                              std::span<const reduction::TileModel> models = reduction::tile_models());

/// A sheet with the setting's scenarios on one tile, as in the paper's Fig. 10, in parallel projection at
/// true scale. Rows have three drawings, and a key follows the last. Each drawing shows the tile at rest with
/// its supports and loads (symbols as in surface_svg()), the pattern's full model under the largest magnitude
/// (grey), and the reduced model, if there is one (blue). If the full model has no equilibrium at the largest
/// magnitude, the last equilibrium before it is drawn, and the caption states the magnitude of this
/// equilibrium.
std::string scenario_sheet_svg(const pattern::NodeLayout& layout, const ReducedPattern& pattern,
                               const reduction::Setting& setting,
                               std::span<const reduction::TileModel> models = reduction::tile_models());

}  // namespace fretwork::exports
