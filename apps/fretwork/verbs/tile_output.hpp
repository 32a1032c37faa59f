// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/internal/json_text.hpp>
#include <fretwork/simulation/project/project.hpp>
#include <fretwork/tiling/tessellate.hpp>

namespace fretwork::app {

// The output of the verbs tile and retile.

/// Measures of the tiles, and the library, the setting and the load cases of the project.
base::Json tiling_json(const tiling::TessellationReport& report, const simulation::Project& project);

/// Print measures of the tiles for people, and the numbers of unpainted tiles and of load cases.
void print_tiling(const tiling::TessellationReport& report, const simulation::Project& project);

}  // namespace fretwork::app
