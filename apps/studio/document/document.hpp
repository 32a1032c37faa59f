// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <studio/document/document_json.hpp>
#include <studio/document/history.hpp>
#include <studio/solving/live_solver.hpp>

#include <filesystem>
#include <optional>

namespace fretwork::studio {

/// A project's file, and the SHA-256 of its content; no hash: there was no such file.
struct ProjectFile {
    std::filesystem::path path;
    std::optional<std::string> hash;
};
/// The SHA-256 of a file; nothing if there is no such file. Throws InputError if it cannot be read.
std::optional<std::string> hash_of_file(const std::filesystem::path& path);

/// The document of a server: its history, its file, and the selected load case.
class Document {
  public:
    /// A document without a file, which is not saved.
    Document(State state, std::int64_t revision);
    /// A document that was read from a file.
    Document(State state, ProjectFile file, std::int64_t revision);
    /// A document whose unsaved changes were found. Undo leads back to the content of its file.
    static Document recovered(Document saved, State changed);
    /// This document with a name, which is used until the document has a file. An empty name changes nothing.
    Document named(std::string name) &&;
    /// This document, marked as saved, because it is an example or a file that was sent.
    Document found_elsewhere() &&;

    [[nodiscard]] const StatePtr& now() const { return history_.now(); }
    [[nodiscard]] const std::optional<std::filesystem::path>& path() const { return path_; }
    /// The SHA-256 of the file when it was read or written last.
    [[nodiscard]] const std::optional<std::string>& file_hash() const { return file_hash_; }
    [[nodiscard]] std::int64_t revision() const { return revision_; }
    [[nodiscard]] bool is_saved() const { return now() == saved_; }
    [[nodiscard]] SolverInput solver_input() const { return {{now(), selected_}, revision_, {}}; }
    [[nodiscard]] DocumentStatus status() const;
    [[nodiscard]] const History& history() const { return history_; }

    /// Add an edited state. If it has more load cases than before, the last one is selected.
    void add(Edited edited);
    /// False if there is nothing to undo, or to redo.
    bool undo();
    bool redo();
    void select_load_case(std::size_t index);
    /// Tell that the present state was written to this file.
    void saved_as(const std::filesystem::path& path, std::string hash);

  private:
    void moved();

    History history_;
    std::optional<std::filesystem::path> path_;
    std::optional<std::string> file_hash_;
    std::string name_ = "untitled";
    StatePtr saved_;
    std::int64_t revision_;
    std::size_t selected_ = 0;
    bool is_recovered_ = false;
};

/// The folder to which paths in a project are relative: the folder of its file or, without a file, the
/// working directory.
std::filesystem::path folder_of(const std::optional<std::filesystem::path>& project);

}  // namespace fretwork::studio
