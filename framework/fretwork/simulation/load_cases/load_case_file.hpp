// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/simulation/load_cases/load_case.hpp>

#include <filesystem>
#include <string>
#include <string_view>

namespace fretwork::simulation {

/// The newest format of load case files, which can express every load case.
inline constexpr std::string_view kLoadCaseFormat = "fretwork/load-case/4";

/// Parse a load case. Throws InputError with source and JSON pointer.
LoadCase parse_load_case(std::string_view text, const std::string& source);
/// The load case as JSON text; parse_load_case gives an equal load case.
std::string load_case_text(const LoadCase& load_case);
/// Read a load case file. Throws InputError with file and JSON pointer.
LoadCase read_load_case(const std::filesystem::path& path);
/// Write a load case file atomically. Throws IoError and leaves the file as it was.
void write_load_case(const LoadCase& load_case, const std::filesystem::path& path);

}  // namespace fretwork::simulation
