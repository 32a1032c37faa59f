// SPDX-License-Identifier: GPL-3.0-or-later
// Run the program as its user does: in a shell, in a folder.
#pragma once

#include <fretwork/base/files/file.hpp>

#include <cstdlib>
#include <filesystem>
#include <string>
#include <sys/wait.h>

namespace fretwork::test {

struct Outcome {
    int exit_code = -1;
    std::string out;
    std::string err;
};

/// Run a command line in which `fretwork` is the program that was built, and `experiments/` is the
/// repository's.
inline Outcome run_command(const std::string& command, const std::filesystem::path& folder) {
    const std::filesystem::path link = folder / "experiments";
    if (!std::filesystem::exists(link)) {
        std::filesystem::create_directory_symlink(std::filesystem::path(FRETWORK_SOURCE_DIR) / "experiments",
                                                  link);
    }
    const std::filesystem::path program = FRETWORK_PROGRAM;
    const std::string line = "cd '" + folder.string() + "' && PATH='" + program.parent_path().string() +
                             "':\"$PATH\" && { " + command + "\n} >.out 2>.err </dev/null";
    const int status = std::system(line.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, base::read_text_file(folder / ".out"),
            base::read_text_file(folder / ".err")};
}

}  // namespace fretwork::test
