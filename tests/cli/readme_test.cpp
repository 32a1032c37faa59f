// SPDX-License-Identifier: GPL-3.0-or-later
// The README is a program: its tour is run, its C++ is compiled elsewhere and must be the very same text.
#include "cli/command.hpp"
#include "support.hpp"

#include <fretwork/base/text.hpp>

#include <vector>

namespace fretwork::app {
namespace THIS_TEST {

using test::run_command;
using test::TemporaryFolder;

std::string readme() {
    return base::read_text_file(FRETWORK_SOURCE_DIR "/README.md");
}

/// The code block of a language that follows a marker.
std::string block_after(const std::string& marker, const std::string& language) {
    const std::string text = readme();
    const std::string fence = "```" + language + "\n";
    const std::size_t start = text.find(fence, text.find(marker));
    if (start == std::string::npos)
        throw base::InputError("README.md has no " + language + " block after " + marker);
    const std::size_t begin = start + fence.size();
    return text.substr(begin, text.find("```", begin) - begin);
}

TEST(Readme, ItsTourRuns) {
    const TemporaryFolder folder;
    for (const std::string& line : base::split(block_after("<!-- tour -->", "sh"), '\n')) {
        if (line.empty()) continue;
        const auto outcome = run_command(line, folder.path());
        ASSERT_EQ(outcome.exit_code, 0) << line << "\n" << outcome.out << outcome.err;
    }
    EXPECT_EQ(
        run_command("fretwork simulate project.json --model condensed --out r.json --vtu r.vtu --svg r.svg",
                    folder.path())
            .exit_code,
        0);
    EXPECT_TRUE(std::filesystem::exists(folder.path() / "r.vtu"));
    EXPECT_TRUE(std::filesystem::exists(folder.path() / "r.svg"));
    for (const char* file : {"surface.svg", "deformed.svg", "full.vtu"}) {
        EXPECT_TRUE(std::filesystem::exists(folder.path() / file)) << file;
    }
}

TEST(Readme, ItsProgramIsTheOneThatTheInstallTestCompiles) {
    EXPECT_EQ(block_after("<!-- program -->", "cpp"),
              base::read_text_file(FRETWORK_SOURCE_DIR "/tests/install/main.cpp"));
}

}  // namespace THIS_TEST
}  // namespace fretwork::app
