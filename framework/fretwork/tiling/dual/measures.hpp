// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/tiling/dual/dual.hpp>
#include <fretwork/tiling/remeshing/size_field.hpp>
#include <fretwork/tiling/tessellate.hpp>

namespace fretwork::tiling::detail {

/// Counts and lengths of a tiling.
struct Measures {
    TessellationReport report;  ///< report with all values that need no outline
    double mean_ratio = 0.0;    ///< mean of the ratio of sides to wanted sides
    /// The sum of four terms: the number of tiles smaller than a quarter of a regular hexagon with the wanted
    /// side; the share of tiles without six sides (or five at the rim); the relative spread of the ratio of
    /// sides to wanted sides; the relative spread of the ratio of areas to squared wanted sides.
    double irregularity = 0.0;
};

/// Measure a tiling. Throws base::Stopped.
Measures measure(const Dual& dual, const SizeField& field, const base::Control& control);

}  // namespace fretwork::tiling::detail
