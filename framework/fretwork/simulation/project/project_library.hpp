// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/library/library.hpp>
#include <fretwork/simulation/model_choice.hpp>
#include <fretwork/simulation/project/project.hpp>

#include <optional>
#include <string>

namespace fretwork::simulation {

/// The path of a project's library; empty if the project names none.
std::string library_path_of(const std::string& project_file, const Project& project);

/// Open the library for simulating a project: `wanted` if it is not empty, else the project's own (its path
/// is relative to the project file), else none. Throws InputError if the project's library has changed since
/// the project was made.
std::optional<library::Library> open_project_library(const std::string& project_file, const Project& project,
                                                     const std::string& wanted);

/// The project's setting, else the library's, else the paper's; `library` may be null. The strength of
/// the material may differ between project and library. Throws InputError if the settings differ otherwise.
reduction::Setting setting_of(const Project& project, const library::Library* library);

/// True if a project with this choice of models needs its library: a tile's model has calibrated parameters,
/// or the project has no setting. Otherwise the project gives the same results without the library.
bool needs_library(const Project& project, const ModelChoice& choice);

/// Read a project, and check that the tile models assigned to individual tiles exist. Throws InputError that
/// names the file and the place.
Project read_checked_project(const std::string& file);

/// Check that every tile has the calibration that its tile model needs. Throws InputError that names the file
/// and the place at which the project sets the tile's model.
void check_calibrations(const std::string& file, const Project& project, const Surface& surface,
                        const ModelChoice& choice);

}  // namespace fretwork::simulation
