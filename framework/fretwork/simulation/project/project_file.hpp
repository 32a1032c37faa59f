// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/simulation/project/project.hpp>

#include <filesystem>
#include <string>
#include <string_view>

namespace fretwork::simulation {

/// Throws InputError with source and JSON pointer.
Project parse_project(std::string_view text, const std::string& source);
/// parse_project gives an equal project.
std::string project_text(const Project& project);
/// Throws InputError with file and JSON pointer.
Project read_project(const std::filesystem::path& path);
/// Throws IoError; then the file is as it was.
void write_project(const Project& project, const std::filesystem::path& path);

}  // namespace fretwork::simulation
