// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/simulation/project/project.hpp>

#include <string>

namespace fretwork::simulation {

/// Check that the tile models of individual tiles exist. Throws InputError with `file` and JSON pointer.
void check_tile_models(const Project& project, const std::string& file);

/// Check what reading a project leaves open, because it may be mended later or belongs to a library: tile
/// models, the interface nodes and tiles that load cases select, and images, drawings and properties of
/// recipes. A property is checked only if the project names no library, which may have properties of its own.
/// Throws InputError with `file`, and with the JSON pointer or the load case and its entry.
void check_project(const Project& project, const std::string& file);

}  // namespace fretwork::simulation
