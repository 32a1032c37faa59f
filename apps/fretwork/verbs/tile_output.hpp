// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/internal/json_text.hpp>
#include <fretwork/simulation/project/project.hpp>
#include <fretwork/tiling/tessellate.hpp>

namespace fretwork::app {

// The output of the verbs tile and retile.

/// Measures of the tiles, and what the project keeps.
base::Json tiling_json(const tiling::TessellationReport& report, const simulation::Project& project);

/// The same for people, in a few lines.
void print_tiling(const tiling::TessellationReport& report, const simulation::Project& project);

}  // namespace fretwork::app
