// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/frame/frame.hpp>
#include <fretwork/reduction/scenarios/scenario.hpp>

#include <vector>

namespace fretwork::reduction::detail {

/// The supports of a tile under a scenario. Interface node i is node i of the frame, here and below.
std::vector<mechanics::Support> supports_of(const Scenario& scenario);

/// The loads on a tile under a scenario with this magnitude, N.
std::vector<mechanics::NodalLoad> loads_of(const Scenario& scenario, double magnitude);

}  // namespace fretwork::reduction::detail
