// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "verbs/solve_output.hpp"

#include <fretwork/simulation/results/surface_result.hpp>

#include <string>
#include <vector>

namespace fretwork::app {

// The output of the verb simulate.

void print_result(const simulation::SurfaceResult& result, const Wanted& wanted);
void print_result_json(const simulation::SurfaceResult& result);

/// The warnings about a result whose model may be wrong, each with an option that helps.
std::vector<std::string> warnings_of(const simulation::SurfaceResult& result);

}  // namespace fretwork::app
