// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "options/file_options.hpp"
#include "verbs.hpp"

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

}  // namespace fretwork::app
