// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/tiling/tessellate.hpp>

#include <vector>

namespace fretwork::tiling {

/// Tile several outlines that lie apart as one tessellation: the tiles, vertices and interface nodes of the
/// first part, then those of the next. Parts share nothing, so each needs its own supports.
///
/// The report is that of the whole: of the outline as `tessellate` says, with the first part's `start`.
/// Throws what `tessellate` throws, with the part's number if there are several.
TessellationResult tessellate_parts(const std::vector<outlines::Outline>& parts,
                                    const pattern::NodeLayout& layout, const TessellationOptions& options);

}  // namespace fretwork::tiling
