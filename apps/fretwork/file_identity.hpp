// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

namespace fretwork::app {

/// Whether two names lead to one file, or would if they were written: by links, by dots, or by other letters
/// where the file system takes `a` for `A`.
bool is_same_file(const std::filesystem::path& left, const std::filesystem::path& right);

/// Something that is written and not replaced: /dev/stdout, /dev/null, a pipe.
bool is_device(const std::filesystem::path& path);

/// The kind that a file claims to be.
struct FileContent {
    bool is_database = false;  ///< SQLite, as every pattern library is
    std::string format{};      ///< K of a JSON file that says "fretwork/K/N"; else empty
    std::string start{};       ///< its first lines; empty: nothing is there, or nothing is in it
};

/// Nothing is known of a file that is missing or cannot be read.
FileContent content_of(const std::filesystem::path& path);

}  // namespace fretwork::app
