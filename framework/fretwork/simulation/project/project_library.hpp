// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/library/library.hpp>
#include <fretwork/simulation/model_choice.hpp>
#include <fretwork/simulation/project/project.hpp>

#include <filesystem>
#include <optional>
#include <string>

namespace fretwork::simulation {

/// The folder to which the path of a project's library is relative: the folder of the project file. A project
/// that is read from or written to a pipe (a named pipe, /dev/stdin) has no folder; its paths are relative to
/// the current folder. Empty: the current folder.
std::filesystem::path folder_of_project(const std::string& project_file);

/// The path by which a project in `project_file` names a library.
std::string library_path_from(const std::string& project_file, const std::filesystem::path& library);

/// The path of a project's library; empty if the project names none.
std::string library_path_of(const std::string& project_file, const Project& project);

/// Make the path of a project's library relative to another project file, in which the project will be
/// written.
void move_library_path(Project& project, const std::string& from_file, const std::string& to_file);

/// Open the library of a simulation: the library at the path `wanted` or, if `wanted` is empty, the project's
/// own library. The path of the project's library is relative to the project file. None if there is no path.
/// Throws as library::Library::open(). Throws InputError if the project's own library is missing or has
/// changed since the project was made.
std::optional<library::Library> open_project_library(const std::string& project_file, const Project& project,
                                                     const std::string& wanted);

/// The setting of a project. With a library: the project's own setting or, if it has none, the library's;
/// a strength that the project's setting lacks is the library's. Without a library (null): the project's
/// own setting or, if it has none, the paper's. The settings of project and library may differ in the
/// strength, and in the shape of the section, with equal areas and moments. Throws InputError if they differ
/// in any other value.
reduction::Setting setting_of(const Project& project, const library::Library* library);

/// True if a project with this choice of models needs its library: the chosen model or a tile's own model has
/// calibrated parameters, or the project has no setting. Otherwise the results do not depend on the library.
/// Throws InputError if a model is unknown.
bool needs_library(const Project& project, const ModelChoice& choice);

/// Read a project, and check that the tile models assigned to individual tiles exist. Throws InputError that
/// names the file and the place.
Project read_checked_project(const std::string& file);

/// Check that every tile is painted, and has a plausible calibration for its tile model. Throws InputError
/// that names the file and, for a tile with its own tile model, the place of this model in the file.
void check_calibrations(const std::string& file, const Project& project, const Surface& surface,
                        const ModelChoice& choice);

}  // namespace fretwork::simulation
