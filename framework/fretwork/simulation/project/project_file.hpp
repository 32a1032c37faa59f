// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/simulation/project/project.hpp>

#include <filesystem>
#include <string>
#include <string_view>

namespace fretwork::simulation {

/// Parse a project. Throws InputError with source and JSON pointer.
Project parse_project(std::string_view text, const std::string& source);
/// The project as JSON text; parse_project gives an equal project. Throws NumericalError if a number is not
/// finite.
std::string project_text(const Project& project);
/// Read a project file. Throws InputError with file and JSON pointer, or if the file cannot be read.
Project read_project(const std::filesystem::path& path);
/// Write a project file atomically. Throws IoError, or as project_text(). After an error, the file is as
/// before.
void write_project(const Project& project, const std::filesystem::path& path);

}  // namespace fretwork::simulation
