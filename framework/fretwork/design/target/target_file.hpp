// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/design/target/target.hpp>

#include <string_view>

namespace fretwork::design {

/// The newest format of target files, which can express every target.
inline constexpr std::string_view kTargetFormat = "fretwork/target/2";

/// Parse a target in a format up to kTargetFormat, which README.md describes. Throws InputError with source
/// and JSON pointer.
Target parse_target(std::string_view text, const std::string& source);
/// The text of a target. Paths of meshes are written unchanged.
std::string target_text(const Target& target);
/// Read a target file. Relative paths of meshes start at the folder of the file. Throws as parse_target().
Target read_target(const std::filesystem::path& path);
/// Write a target file atomically. Throws IoError and leaves the file as it was.
void write_target(const Target& target, const std::filesystem::path& path);

}  // namespace fretwork::design
