// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace fretwork::app {

/// Whether two names lead to one file, also through links and dots. For files that do not exist, whether the
/// names will lead to one file once it is written.
bool is_same_file(const std::filesystem::path& left, const std::filesystem::path& right);

/// Whether a path exists and is neither a regular file nor a folder: /dev/null, a pipe, a terminal.
bool is_device(const std::filesystem::path& path);

// The kinds of content of files that this program makes, as content_of() names them. A JSON file has the K of
// its "fretwork/K/N" as its kind, a table the start of its header.
inline constexpr std::string_view kLibraryContent = "library";  ///< or another database of SQLite
inline constexpr std::string_view kDrawnContent =
    "drawn";  ///< drawings, meshes and decks, which name this program
inline constexpr std::string_view kListContent = "list";    ///< begins with the id of a pattern
inline constexpr std::string_view kOtherContent = "other";  ///< no content of this program

/// The kind of a file's content. The kind is empty if there is no regular file, or if the file is empty or
/// cannot be read. The kind of a frame is "frame" only if this program would write the same bytes, and
/// "other" otherwise, because people write frames, too.
std::string content_of(const std::filesystem::path& path);

/// Whether a content is a table.
bool is_table(std::string_view content);

/// The content in words: "a project", "a table of another kind".
std::string in_words(std::string_view content);

}  // namespace fretwork::app
