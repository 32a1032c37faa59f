// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/exports/tables/line_set.hpp>

namespace fretwork::exports::detail {

/// The beams of a model of small displacements whose first nodes have moved, a row of `moved` for each. The
/// other nodes bear no loads, and follow.
LineSet bent_beams(mechanics::Frame beams, const mechanics::NodeValues& moved);

}  // namespace fretwork::exports::detail
