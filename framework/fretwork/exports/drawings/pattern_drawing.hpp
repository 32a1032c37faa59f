// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/pattern/node_layout.hpp>
#include <fretwork/pattern/pattern.hpp>

#include <span>
#include <string>

namespace fretwork::exports {

struct PatternDrawingOptions {
    double tile_side = 0.025980762113533160;  ///< m, the paper's
    double beam_width = 0.002;                ///< m
    int sides = 6;
};

/// The layout with its candidate edges, and many patterns as a sheet of fans with their ids, as in the
/// paper's Fig. 3b and Fig. 2.
std::string pattern_sheet_svg(const pattern::NodeLayout& layout, std::span<const pattern::Pattern> patterns,
                              const PatternDrawingOptions& options = {});

}  // namespace fretwork::exports
