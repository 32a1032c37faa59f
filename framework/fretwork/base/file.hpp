// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace fretwork::base {

/// Read a whole file. Throws InputError if it is missing, a folder, or unreadable.
std::string read_text_file(const std::filesystem::path& path);

/// Put `content` in the place of `path`, all of it or nothing: a temporary file beside it is written, flushed
/// to the disk and renamed. Throws IoError (folder missing, no permission, disk full), and then `path` is as
/// it was.
void write_file_atomically(const std::filesystem::path& path, std::string_view content);

}  // namespace fretwork::base
