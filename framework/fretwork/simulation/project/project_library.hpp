// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/library/library.hpp>
#include <fretwork/simulation/model_choice.hpp>
#include <fretwork/simulation/project/project.hpp>

#include <optional>
#include <string>

namespace fretwork::simulation {

/// Where a project's library lies; empty if it names none.
std::string library_path_of(const std::string& project_file, const Project& project);

/// The library that a project is to be simulated with: the one that is asked for, else the project's own (its
/// path is relative to the project file), else none. Throws InputError if the project's library has changed
/// since the project was made.
std::optional<library::Library> open_project_library(const std::string& project_file, const Project& project,
                                                     const std::string& wanted);

/// The project's setting, else the library's, else the paper's; `library` may be null. A project may replace
/// the strength of a library's setting. Throws InputError if the library is one of another setting.
reduction::Setting setting_of(const Project& project, const library::Library* library);

/// Whether a project under this choice of models needs its library: a tile's model has calibrated parameters,
/// or the project carries no setting. All else means the same without it.
bool needs_library(const Project& project, const ModelChoice& choice);

/// Read a project, and check that there are the tile models that it names for single tiles. Throws InputError
/// that names the file and the place.
Project read_checked_project(const std::string& file);

/// Every tile must have the calibration that its tile model needs. Throws InputError that names the file, and
/// the place where the project chose a tile's model.
void check_calibrations(const std::string& file, const Project& project, const Surface& surface,
                        const ModelChoice& choice);

}  // namespace fretwork::simulation
