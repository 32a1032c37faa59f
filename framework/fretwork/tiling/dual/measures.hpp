// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/tiling/dual/dual.hpp>
#include <fretwork/tiling/remeshing/size_field.hpp>
#include <fretwork/tiling/tessellate.hpp>

namespace fretwork::tiling::detail {

/// Counts and lengths of a tiling.
struct Measures {
    TessellationReport report;  ///< known without the outline
    double mean_ratio = 0.0;    ///< mean of sides over the sides wanted there
    /// The share of tiles with another number of sides than they should have (six; at the rim also five), and
    /// the relative spreads of sides and areas, both over what is wanted there.
    double irregularity = 0.0;
};

/// Throws base::Stopped.
Measures measure(const Dual& dual, const SizeField& field, const base::Control& control);

}  // namespace fretwork::tiling::detail
