// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/design/target/target.hpp>

#include <string_view>

namespace fretwork::design {

/// The newest format of target files, which can express every target.
inline constexpr std::string_view kTargetFormat = "fretwork/target/2";

/// Parse a target in kTargetFormat or an older format (see README.md of design). Throws InputError that names
/// `source` and the JSON pointer of the wrong value or, in malformed JSON, line and column.
Target parse_target(std::string_view text, const std::string& source);
/// The text of a target, in the oldest format that can express it. Paths of meshes are written unchanged.
/// Throws NumericalError if a number is not finite.
std::string target_text(const Target& target);
/// Read a target file. A relative path of a mesh starts at the folder of the target file; in the result, this
/// folder is put before the path. Throws as parse_target(), and InputError if the file cannot be read.
Target read_target(const std::filesystem::path& path);
/// Write a target file atomically. Throws IoError, or as target_text(). After an error, the file is
/// as before.
void write_target(const Target& target, const std::filesystem::path& path);

}  // namespace fretwork::design
