// SPDX-License-Identifier: GPL-3.0-or-later
// Commands that must be refused: exit code 2, one line on stderr, nothing on stdout, and no file left behind.
#pragma once

#include "cli/command.hpp"
#include "support.hpp"

#include <algorithm>

namespace fretwork::test {

inline std::size_t files_in(const std::filesystem::path& folder) {
    return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(folder), {}));
}

inline void expect_refused(const std::string& command, const std::filesystem::path& folder,
                           const std::string& complaint) {
    run_command("true", folder);  // so that the files of running a command are there before we count
    const std::size_t files = files_in(folder);
    const Outcome outcome = run_command(command, folder);
    EXPECT_EQ(outcome.exit_code, 2) << command << "\n" << outcome.err;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << command << "\n" << outcome.err;
    EXPECT_THAT(outcome.err, testing::StartsWith("fretwork: ")) << command;
    EXPECT_THAT(outcome.err, testing::HasSubstr(complaint)) << command;
    EXPECT_EQ(outcome.out, "") << command;
    EXPECT_EQ(files_in(folder), files) << command << " left a file behind";
}

}  // namespace fretwork::test
