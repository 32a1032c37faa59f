// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>

#include <initializer_list>
#include <string_view>

namespace fretwork::app {

/// The kind of a file.
struct FileKind {
    std::string_view name;      ///< for people: "a project"
    std::string_view endings;   ///< those that a new file may have, with spaces between; empty: any
    std::string_view contents;  ///< what it may replace, named as in file_identity.hpp, with spaces between
    bool is_several = false;    ///< further files are made beside it
    /// True: the verb compares its files with those in the folder, and refuses to replace a file by a
    /// different one.
    bool is_compared = false;
};

/// Whether a text that begins like this is a drawing, a mesh or a deck of this program.
bool says_who_made_it(std::string_view start);

inline constexpr FileKind kProjectFile{"a project", ".json", "project"};
inline constexpr FileKind kResultFile{"a result", ".json", "result"};
inline constexpr FileKind kFrameFile{"a frame", ".json", "frame"};
inline constexpr FileKind kLibraryFile{"a pattern library", ".db .sqlite .sqlite3", "library"};
/// A table replaces only tables with its own header, because tables of other kinds may hold hours of work.
inline constexpr FileKind kCensusFile{"a census", ".csv", "edges,patterns,"};
inline constexpr FileKind kClassesFile{"a table of classes", ".csv", "id,edges,symmetry,"};
inline constexpr FileKind kKnownFile{"a table of best known values", ".csv", "problem,best_value,"};
inline constexpr FileKind kBeamTableFile{"a table of beams", ".csv .json", "beam,tile, beams"};
inline constexpr FileKind kListFile{"a list", ".txt .csv", "list"};
inline constexpr FileKind kSvgFile{"a drawing", ".svg", "drawn"};
inline constexpr FileKind kVtuFile{"a file for ParaView", ".vtu", "drawn"};
inline constexpr FileKind kSeriesFile{"a series for ParaView", ".pvd", "drawn", true};
inline constexpr FileKind kPageFile{"a page", ".html", "drawn"};
inline constexpr FileKind kDeckFile{"an input deck", ".inp", "drawn"};
/// Drawings, meshes, tables of nodes, and facts of what is made.
inline constexpr FileKind kExportFile{"a drawing or a mesh", "", "drawn node,x_m, facts"};

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
    return {option, FileRole::OutputFolder, {"a folder", files, ""}};
}

/// The same for a verb that compares: a file that exists must equal the one that is made.
inline DeclaredFile compared_folder(const char* option, std::string_view files) {
    return {option, FileRole::OutputFolder, {"a folder", files, "", false, true}};
}

/// Say which options of a verb name files, all of them in one place: what is declared is checked before any
/// verb runs (check_files in program.hpp). Call it after the options are added. Pre: the verb belongs to a
/// Program.
void declare_files(CLI::App& verb, std::initializer_list<DeclaredFile> files);

}  // namespace fretwork::app
