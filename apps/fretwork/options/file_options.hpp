// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>

#include <filesystem>
#include <initializer_list>
#include <string_view>

namespace fretwork::app {

/// The kind of a file.
struct FileKind {
    std::string_view name;     ///< for people: "a project"
    std::string_view endings;  ///< those that a new file may have, with spaces between; empty: any
    std::string_view format;   ///< JSON files of this kind say "fretwork/<format>/N"; empty: it is not JSON
    /// Whether a text that begins like this was made by this program; null: texts of this kind are JSON, or
    /// none.
    bool (*is_ours)(std::string_view start) = nullptr;
    /// For JSON that people write, too: whether a file is, byte for byte, as this program writes it.
    bool (*is_as_written)(const std::filesystem::path& path) = nullptr;
    bool is_several = false;  ///< further files are made beside it
};

/// Drawings, meshes and decks say so.
bool says_who_made_it(std::string_view start);
/// Tables have one of our headers.
bool is_our_table(std::string_view start);
bool is_frame_as_written(const std::filesystem::path& path);
/// Lists begin with the id of a pattern.
bool is_list_of_patterns(std::string_view start);

inline constexpr FileKind kProjectFile{"a project", ".json", "project"};
inline constexpr FileKind kResultFile{"a result", ".json", "result"};
inline constexpr FileKind kFrameFile{"a frame", ".json", "frame", nullptr, is_frame_as_written};
inline constexpr FileKind kLibraryFile{"a pattern library", ".db .sqlite .sqlite3", ""};
/// Each kind of table has its own header; tables of other kinds may hold hours of work.
inline constexpr FileKind kCensusFile{
    "a census", ".csv", "", [](std::string_view start) { return start.starts_with("edges,patterns,"); }};
inline constexpr FileKind kClassesFile{"a table of classes", ".csv", "", [](std::string_view start) {
                                           return start.starts_with("id,edges,symmetry,");
                                       }};
inline constexpr FileKind kKnownFile{"a table of best known values", ".csv", "", [](std::string_view start) {
                                         return start.starts_with("problem,best_value,");
                                     }};
inline constexpr FileKind kBeamTableFile{
    "a table of beams", ".csv .json", "beams",
    [](std::string_view start) { return start.starts_with("beam,tile,"); }};
inline constexpr FileKind kListFile{"a list", ".txt .csv", "", is_list_of_patterns};
inline constexpr FileKind kSvgFile{"a drawing", ".svg", "", says_who_made_it};
inline constexpr FileKind kVtuFile{"a file for ParaView", ".vtu", "", says_who_made_it};
inline constexpr FileKind kSeriesFile{"a series for ParaView", ".pvd", "", says_who_made_it, nullptr, true};
inline constexpr FileKind kDeckFile{"an input deck", ".inp", "", says_who_made_it};
/// Drawings, meshes, tables of nodes, and facts of what is made.
inline constexpr FileKind kExportFile{"a drawing or a mesh", "", "facts", [](std::string_view start) {
                                          return says_who_made_it(start) || start.starts_with("node,x_m,");
                                      }};

/// The effect of a command on a file that an option names.
enum class FileRole {
    Input,         ///< reads it; an option may also take another text, such as the name of a layout
    Output,        ///< makes it, or puts a new one in its place
    Update,        ///< reads and changes it, or makes it
    OutputFolder,  ///< makes files in it: those whose ending, or whole name, is among the kind's endings
};

struct FileOption {
    const CLI::Option* option;
    FileRole role;
    FileKind kind;
};

/// One row of a verb's declaration.
struct DeclaredFile {
    const char* option;  ///< "--out", or the name of a positional
    FileRole role;
    FileKind kind;
};

inline DeclaredFile input(const char* option) {
    return {option, FileRole::Input, {}};
}
inline DeclaredFile output(const char* option, FileKind kind) {
    return {option, FileRole::Output, kind};
}
inline DeclaredFile update(const char* option, FileKind kind) {
    return {option, FileRole::Update, kind};
}
/// @param files  the endings or names of the files that are made, with spaces between
inline DeclaredFile output_folder(const char* option, std::string_view files) {
    return {option, FileRole::OutputFolder, {"a folder", files, "", is_our_table}};
}

/// Say which options of a verb name files, all of them in one place: what is declared is checked before any
/// verb runs (file_guard.hpp). Call it when the verb has its options. The verb belongs to a Program.
void declare_files(CLI::App& verb, std::initializer_list<DeclaredFile> files);

}  // namespace fretwork::app
