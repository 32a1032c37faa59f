// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/tiling/dual/dual.hpp>
#include <fretwork/tiling/remeshing/size_field.hpp>
#include <fretwork/tiling/tessellate.hpp>

namespace fretwork::tiling::detail {

/// Counts and lengths of a tiling.
struct Measures {
    TessellationReport report;  ///< all values that need no outline
    double mean_ratio = 0.0;    ///< mean of the ratio of sides to wanted sides
    /// A sum of three terms: the share of tiles with a wrong number of sides (right are six, at the rim also
    /// five), and the relative spreads of sides and of areas, both relative to the wanted ones.
    double irregularity = 0.0;
};

/// Measure a tiling. Throws base::Stopped.
Measures measure(const Dual& dual, const SizeField& field, const base::Control& control);

}  // namespace fretwork::tiling::detail
