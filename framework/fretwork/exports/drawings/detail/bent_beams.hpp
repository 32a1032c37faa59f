// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/exports/tables/line_set.hpp>

namespace fretwork::exports::detail {

/// The beams of a model, bent at small displacements. The first nodes have the motions in the rows of
/// `moved`; all other nodes are in equilibrium without loads.
LineSet bent_beams(mechanics::Frame beams, const mechanics::NodeValues& moved);

}  // namespace fretwork::exports::detail
