// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/pattern/node_layout.hpp>
#include <fretwork/pattern/pattern.hpp>
#include <fretwork/reduction/calibration/calibration.hpp>

#include <optional>
#include <span>
#include <string>

namespace fretwork::exports {

/// A pattern and a reduced model of beams that was fitted to it, if there is one.
struct ReducedPattern {
    pattern::Pattern pattern;
    std::optional<reduction::Calibration> calibration{};
};

/// Patterns with their reduced models beside them in the setting's polygon, at true scale, with ids, the
/// twist theta and the objective: as in the paper's Fig. 8.
std::string reduced_sheet_svg(const pattern::NodeLayout& layout, std::span<const ReducedPattern> patterns,
                              const reduction::Setting& setting,
                              std::span<const reduction::TileModel> models = reduction::tile_models());

}  // namespace fretwork::exports
