// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/frame/frame.hpp>
#include <fretwork/reduction/scenarios/scenario.hpp>

#include <vector>

namespace fretwork::reduction::detail {

/// The supports of a tile in a scenario; interface node i is node i.
std::vector<mechanics::Support> supports_of(const Scenario& scenario);

/// The loads on a tile in a scenario at a magnitude, N.
std::vector<mechanics::NodalLoad> loads_of(const Scenario& scenario, double magnitude);

}  // namespace fretwork::reduction::detail
