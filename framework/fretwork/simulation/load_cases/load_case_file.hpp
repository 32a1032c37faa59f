// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/simulation/load_cases/load_case.hpp>

#include <filesystem>
#include <string>
#include <string_view>

namespace fretwork::simulation {

/// The newest form of the file, which says all that a load case can.
inline constexpr std::string_view kLoadCaseFormat = "fretwork/load-case/3";

/// Throws InputError with source and JSON pointer.
LoadCase parse_load_case(std::string_view text, const std::string& source);
/// parse_load_case gives an equal load case.
std::string load_case_text(const LoadCase& load_case);
/// Throws InputError with file and JSON pointer.
LoadCase read_load_case(const std::filesystem::path& path);
/// Throws IoError; then the file is as it was.
void write_load_case(const LoadCase& load_case, const std::filesystem::path& path);

}  // namespace fretwork::simulation
