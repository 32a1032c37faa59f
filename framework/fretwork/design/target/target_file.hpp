// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/design/target/target.hpp>

#include <string_view>

namespace fretwork::design {

/// The newest format of target files, which can express every target.
inline constexpr std::string_view kTargetFormat = "fretwork/target/2";

/// Parse a target in kTargetFormat or an older format (see README.md of design). Throws InputError that names
/// `source` and the JSON pointer of the wrong value.
Target parse_target(std::string_view text, const std::string& source);
/// The text of a target, in the oldest format that can express it. Paths of meshes are written unchanged.
std::string target_text(const Target& target);
/// Read a target file. Relative paths of meshes begin at the folder of the target file, and get it as a
/// prefix. Throws as parse_target().
Target read_target(const std::filesystem::path& path);
/// Write a target file atomically. If this fails, throws IoError; the file then stays as it was.
void write_target(const Target& target, const std::filesystem::path& path);

}  // namespace fretwork::design
