// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/command.hpp"
#include "support.hpp"

namespace fretwork::app {
namespace {

using test::run_command;
using test::TemporaryFolder;
using testing::HasSubstr;

TEST(Help, OfEveryVerbHasAnExample) {
    const TemporaryFolder folder;
    for (const std::string verb : {"enumerate", "calibrate", "library", "tile", "paint", "case", "simulate",
                                   "compare", "solve", "optimizers", "export", "draw", "beams", "studio"}) {
        const auto outcome = run_command("fretwork " + verb + " --help", folder.path());
        EXPECT_EQ(outcome.exit_code, 0) << verb;
        EXPECT_THAT(outcome.out, testing::ContainsRegex("Examples?:(.|\n)* fretwork " + verb)) << verb;
        EXPECT_EQ(outcome.err, "") << verb;
        EXPECT_THAT(run_command("fretwork --help", folder.path()).out, HasSubstr("  " + verb));
    }
}

TEST(Help, OfEveryActionHasAnExample) {
    const TemporaryFolder folder;
    for (const std::string action :
         {"library list", "library show", "library merge", "library export", "optimizers list",
          "optimizers known", "optimizers run", "optimizers landscape", "case add", "case list", "case show",
          "case remove", "case rename"}) {
        const auto outcome = run_command("fretwork " + action + " --help", folder.path());
        EXPECT_EQ(outcome.exit_code, 0) << action;
        EXPECT_THAT(outcome.out, testing::ContainsRegex("Examples?:(.|\n)* fretwork " + action)) << action;
    }
}

TEST(Help, VersionIsOneLine) {
    const TemporaryFolder folder;
    EXPECT_THAT(run_command("fretwork --version", folder.path()).out,
                testing::MatchesRegex("[0-9]+\\.[0-9]+\\.[0-9]+\n"));
}

}  // namespace
}  // namespace fretwork::app
