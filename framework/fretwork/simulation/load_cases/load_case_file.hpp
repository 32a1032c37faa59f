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
/// The load case as JSON text, in the oldest format that can express it. parse_load_case() gives an equal
/// load case. Throws NumericalError if a number is not finite.
std::string load_case_text(const LoadCase& load_case);
/// Read a load case file. Throws as parse_load_case(), and InputError if the file cannot be read.
LoadCase read_load_case(const std::filesystem::path& path);
/// Write a load case file atomically. Throws IoError, or as load_case_text(). After an error, the file is as
/// before.
void write_load_case(const LoadCase& load_case, const std::filesystem::path& path);

}  // namespace fretwork::simulation
