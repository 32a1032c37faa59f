// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/command.hpp"
#include "support.hpp"

namespace fretwork::app {
namespace THIS_TEST {

using test::run_command;
using test::TemporaryFolder;
using testing::HasSubstr;

/// The words that bash offers for the last of these.
std::string offered(const std::string& words, const std::filesystem::path& folder) {
    const auto outcome =
        run_command("bash -c 'source <(fretwork manual --bash); COMP_WORDS=(" + words +
                        "); COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); _fretwork; echo \"${COMPREPLY[*]}\"'",
                    folder);
    EXPECT_EQ(outcome.err, "");
    return outcome.out;
}

TEST(Manual, BashOffersVerbsOptionsAndValues) {
    const TemporaryFolder folder;
    EXPECT_EQ(offered("fretwork simul", folder.path()), "simulate\n");
    EXPECT_EQ(offered("fretwork case re", folder.path()), "remove rename\n");
    EXPECT_EQ(offered("fretwork draw --tile", folder.path()), "--tile-side\n");
    EXPECT_EQ(offered("fretwork calibrate --policy \"\"", folder.path()), "paper stable\n");
    EXPECT_EQ(offered("fretwork draw --out dra", folder.path()), "\n");  // the name of a file
}

TEST(Manual, PageNamesEveryVerb) {
    const TemporaryFolder folder;
    const auto outcome = run_command("fretwork manual --man", folder.path());
    EXPECT_EQ(outcome.exit_code, 0);
    for (const std::string heading : {"fretwork tile", "fretwork case add", "fretwork library show"})
        EXPECT_THAT(outcome.out, HasSubstr(".SH \"" + heading + "\""));
    EXPECT_THAT(outcome.out, HasSubstr(".B \\-\\-edge\\-length"));
}

TEST(Manual, PageIsSetWithoutAWarning) {
    const TemporaryFolder folder;
    if (run_command("command -v groff", folder.path()).exit_code != 0) GTEST_SKIP() << "groff is missing";
    const auto outcome =
        run_command("fretwork manual --man > fretwork.1 && groff -man -ww -Tutf8 fretwork.1", folder.path());
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_EQ(outcome.err, "");
    EXPECT_THAT(outcome.out, HasSubstr("edge"));
}

TEST(Manual, NeedsOneForm) {
    const TemporaryFolder folder;
    EXPECT_EQ(run_command("fretwork manual", folder.path()).exit_code, 2);
    EXPECT_EQ(run_command("fretwork manual --man --bash", folder.path()).exit_code, 2);
}

}  // namespace THIS_TEST
}  // namespace fretwork::app
