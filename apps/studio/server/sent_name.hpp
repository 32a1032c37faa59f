// SPDX-License-Identifier: GPL-3.0-or-later
// Names and paths that come in messages.
#pragma once

#include <fretwork/base/json_reader.hpp>

#include <filesystem>
#include <string>

namespace fretwork::studio {

/// A text without the character NUL, at which the system would end a path.
std::string read_plain_text(const base::JsonReader& json);

/// The placeholder for a long text in a message.
std::string shown_name(const std::string& name);

/// A name of the program's own, or the path of a file. Throws InputError if it is longer than any path.
std::string read_name_or_path(const base::JsonReader& json);

/// The absolute path of a file on this machine, which need not be there. Throws InputError if the system can
/// have no such file.
std::filesystem::path read_path(const base::JsonReader& json);

/// The name of a file on the page's machine: not empty, and at most 255 bytes, as file systems have it.
std::string read_file_name(const base::JsonReader& json);

}  // namespace fretwork::studio
