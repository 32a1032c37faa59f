// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/design/target/target.hpp>

#include <string_view>

namespace fretwork::design {

/// Read a target ("fretwork/target/1", README.md). Throws InputError with source and JSON pointer.
Target parse_target(std::string_view text, const std::string& source);
/// Paths of meshes are as in the target.
std::string target_text(const Target& target);
/// The same from a file; relative paths of meshes start at its folder.
Target read_target(const std::filesystem::path& path);
/// The file is replaced whole or not touched. Throws IoError.
void write_target(const Target& target, const std::filesystem::path& path);

}  // namespace fretwork::design
