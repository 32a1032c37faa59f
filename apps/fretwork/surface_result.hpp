// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/simulation/results/surface_result.hpp>

#include <string>

namespace fretwork::app {

/// Read a surface's result, and check what it says that it is a result of. One of an older program does not
/// say so; it is taken at its word, and that is told on standard error.
simulation::SurfaceResult read_surface_result(const std::string& file);

}  // namespace fretwork::app
