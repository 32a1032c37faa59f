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
    double tile_side = 0.025980762113533160;  ///< m, the paper's
    double beam_width = 0.002;                ///< m
    int sides = 6;                            ///< of the polygon
};

/// The layout with its candidate edges, and many patterns as a sheet of fans with their ids, as in the
/// paper's Fig. 3b and Fig. 2.
std::string pattern_sheet_svg(const pattern::NodeLayout& layout, std::span<const pattern::Pattern> patterns,
                              const PatternDrawingOptions& options = {});

/// Rejected graphs as a sheet of fans, as in the paper's Fig. 7: one row for each filter, the guilty beams in
/// red, and the reason below.
std::string rejection_sheet_svg(const pattern::NodeLayout& layout,
                                std::span<const pattern::Rejection> rejections,
                                const PatternDrawingOptions& options = {});

/// A pattern and, if there is one, the reduced model of beams fitted to it.
struct ReducedPattern {
    pattern::Pattern pattern;                             ///< what is drawn
    std::optional<reduction::Calibration> calibration{};  ///< of the model beside it
};

/// Patterns with their reduced models beside them, as in the paper's Fig. 8: in the setting's polygon, at
/// true scale, with ids, the twist theta and the objective.
std::string reduced_sheet_svg(const pattern::NodeLayout& layout, std::span<const ReducedPattern> patterns,
                              const reduction::Setting& setting,
                              std::span<const reduction::TileModel> models = reduction::tile_models());

/// The setting's scenarios on one tile, side by side as in the paper's Fig. 10, in parallel projection at
/// true scale: the tile at rest with its supports and loads (symbols as in surface_svg), the pattern's full
/// model under the largest magnitude (grey), and the reduced model, if there is one (blue). If the full model
/// has no equilibrium at the largest magnitude, its last equilibrium before is drawn, and the caption states
/// the magnitude.
std::string scenario_sheet_svg(const pattern::NodeLayout& layout, const ReducedPattern& pattern,
                               const reduction::Setting& setting,
                               std::span<const reduction::TileModel> models = reduction::tile_models());

}  // namespace fretwork::exports
