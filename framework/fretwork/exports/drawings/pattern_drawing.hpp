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
    int sides = 6;                            ///< number of sides of the polygon, at least 3
};

/// A sheet with the layout and its candidate edges (the paper's Fig. 3b), and with the fan (pattern::Fan) and
/// the id of each pattern (Fig. 2). A sheet with up to five columns of drawings is for a journal's column
/// (84 mm), and one with up to twelve is for a page (177 mm). If the sheet is scaled to this width, its text
/// is legible (6 pt). The sheet states the width (`data-print-width`); a sheet with more columns states none.
/// The same holds for the sheets below. Throws InputError if the polygon in `options` has fewer than three
/// sides, or if its side is not above zero.
std::string pattern_sheet_svg(const pattern::NodeLayout& layout, std::span<const pattern::Pattern> patterns,
                              const PatternDrawingOptions& options = {});

/// A sheet with rejected graphs as fans, as in the paper's Fig. 7. Successive rejections by the same filter
/// are one row. Beams that break the rule (Verdict::guilty) are red; id and reason are below each fan. Throws
/// as pattern_sheet_svg().
std::string rejection_sheet_svg(const pattern::NodeLayout& layout,
                                std::span<const pattern::Rejection> rejections,
                                const PatternDrawingOptions& options = {});

/// A pattern and, optionally, a reduced model of beams that was calibrated to it.
struct ReducedPattern {
    pattern::Pattern pattern;  ///< the pattern
    /// Calibration of the reduced model; none: only the pattern is drawn.
    std::optional<reduction::Calibration> calibration{};
};

/// A sheet with patterns and their reduced models side by side, as in the paper's Fig. 8, in the setting's
/// polygon at true scale. Below are the pattern's id, the model's parameters that are angles (such as the
/// twist theta of a ring), in degrees, and the objective of the calibration. Throws InputError if `models`
/// has no row for a calibration, or a row with other parameters.
std::string reduced_sheet_svg(const pattern::NodeLayout& layout, std::span<const ReducedPattern> patterns,
                              const reduction::Setting& setting,
                              std::span<const reduction::TileModel> models = reduction::tile_models());

/// A sheet with the setting's scenarios on one tile, as in the paper's Fig. 10, in parallel projection at
/// true scale. Rows have three drawings, and a key follows the last. Each drawing shows the polygon at rest
/// with its supports and loads (symbols as in surface_svg()), the pattern's full model under the largest
/// magnitude (grey), and the linear solution of the reduced model, if there is one (blue). If the full model
/// has no equilibrium at the largest magnitude, both models are drawn at its last equilibrium before. The
/// caption states the drawn magnitude. Throws as reduced_sheet_svg(), and NumericalError if a model cannot be
/// solved.
std::string scenario_sheet_svg(const pattern::NodeLayout& layout, const ReducedPattern& pattern,
                               const reduction::Setting& setting,
                               std::span<const reduction::TileModel> models = reduction::tile_models());

}  // namespace fretwork::exports
