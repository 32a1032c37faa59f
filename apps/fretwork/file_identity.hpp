// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace fretwork::app {

/// Whether two names lead to one file, or would if they were written, by links or dots.
bool is_same_file(const std::filesystem::path& left, const std::filesystem::path& right);

/// Something that is written and not replaced: /dev/stdout, /dev/null, a pipe.
bool is_device(const std::filesystem::path& path);

// The contents of files that this program makes, as content_of() names them. JSON files have the K of their
// "fretwork/K/N", and tables the start of their header.
inline constexpr std::string_view kLibraryContent = "library";  ///< or another database of SQLite
inline constexpr std::string_view kDrawnContent =
    "drawn";  ///< drawings, meshes and decks: they say who made them
inline constexpr std::string_view kListContent = "list";    ///< begins with the id of a pattern
inline constexpr std::string_view kOtherContent = "other";  ///< no content of this program

/// Empty if nothing is there, or nothing is in it. A frame is one only if it is as this program writes it,
/// byte for byte: people write frames, too.
std::string content_of(const std::filesystem::path& path);

/// Whether a content is a table.
bool is_table(std::string_view content);

/// "a project", "a table of another kind"
std::string in_words(std::string_view content);

}  // namespace fretwork::app
