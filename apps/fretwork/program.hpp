// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "options/file_options.hpp"
#include "verbs.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace fretwork::app {

/// The command line: all verbs, and which of their options name files.
class Program final : public CLI::App {
  public:
    /// @param exit_code  where a verb writes how it ended
    explicit Program(ExitCode& exit_code);

    void declare(FileOption option) { file_options_.push_back(option); }
    [[nodiscard]] const std::vector<FileOption>& file_options() const { return file_options_; }

  private:
    std::vector<FileOption> file_options_;
};

/// The verb with this name among those of a program or of another verb. Throws InputError that suggests the
/// nearest name, lists all names, or says that `app` has no verbs of its own.
const CLI::App& find_verb(const CLI::App& app, const std::string& wanted);

/// Refuse a command line whose files do not go together, before anything is computed: an output that is an
/// input or another output (also by way of links or another spelling), whose name lacks the ending of its
/// kind of file, that is a link to a file with another ending, or whose folder is missing or not writable. An
/// existing file is replaced only if it is empty or has the same kind of content. Throws InputError that
/// names the file.
void check_files(const Program& program);
/// Refuse files that a verb makes beside a named one, such as the steps of a series, if an option of the
/// command line names one of them, too. Throws InputError that names the file. Pre: the verb belongs to a
/// Program.
void check_files_beside(const CLI::App& verb, const std::vector<std::filesystem::path>& made);

}  // namespace fretwork::app
