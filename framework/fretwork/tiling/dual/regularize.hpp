// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/tiling/dual/dual.hpp>

namespace fretwork::tiling::detail {

/// Make the cells as regular as they can be together: again and again, every cell wants its vertices on the
/// regular polygon nearest to it, and every vertex goes to the mean of what its cells want. Cells that are
/// far from regular pull harder and harder. Vertices of the rim slide along the outline, never past each
/// other; its corners stay. Convex cells stay convex at vertices that divide sides.
void regularize(Dual& dual, const Rim& rim, int iterations, const Work& work);

/// The same, while each side pulls at its ends, too, towards its wanted length: sides at the rim, which the
/// outline cuts, become as long as the others where angles allow.
void even_out(Dual& dual, const Rim& rim, const SizeField& field, int iterations, const Work& work);

}  // namespace fretwork::tiling::detail
