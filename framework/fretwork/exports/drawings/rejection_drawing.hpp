// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/exports/drawings/pattern_drawing.hpp>
#include <fretwork/pattern/rejections.hpp>

#include <span>
#include <string>

namespace fretwork::exports {

/// Rejected graphs as a sheet of fans, the guilty beams in red and the reason below, one row for each filter:
/// as in the paper's Fig. 7.
std::string rejection_sheet_svg(const pattern::NodeLayout& layout,
                                std::span<const pattern::Rejection> rejections,
                                const PatternDrawingOptions& options = {});

}  // namespace fretwork::exports
