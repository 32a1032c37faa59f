// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/command.hpp"
#include "support.hpp"

#include <algorithm>

namespace fretwork::app {
namespace THIS_TEST {

using test::run_command;
using test::TemporaryFolder;
using testing::HasSubstr;

TEST(Help, OfEveryVerbHasAnExample) {
    const TemporaryFolder folder;
    for (const std::string verb :
         {"enumerate", "calibrate", "library", "tile", "retile", "paint", "case", "simulate", "compare",
          "solve", "optimizers", "export", "draw", "beams", "studio", "design", "check", "help", "manual"}) {
        const auto outcome = run_command("fretwork " + verb + " --help", folder.path());
        EXPECT_EQ(outcome.exit_code, 0) << verb;
        EXPECT_THAT(outcome.out, testing::ContainsRegex("Examples?:(.|\n)* fretwork " + verb)) << verb;
        EXPECT_EQ(outcome.err, "") << verb;
        EXPECT_THAT(run_command("fretwork --help", folder.path()).out, HasSubstr("  " + verb));
    }
}

/// Limits are numbers: "Maximum number of", "Largest", not "Most".
TEST(Help, SaysWhatALimitCounts) {
    const TemporaryFolder folder;
    for (const std::string verb :
         {"enumerate", "calibrate", "library find", "design", "optimizers run", "simulate"})
        EXPECT_THAT(run_command("fretwork " + verb + " --help", folder.path()).out,
                    testing::Not(testing::ContainsRegex("  (The most|Most|Of) [a-z]")))
            << verb;
}

TEST(Help, SaysInWhatADecksProgramDiffers) {
    const TemporaryFolder folder;
    for (const std::string verb : {"solve", "simulate"})
        EXPECT_THAT(run_command("fretwork " + verb + " --help", folder.path()).out,
                    testing::ContainsRegex("[Rr]ectangular bars are"))
            << verb;
}

TEST(Help, OfCalibrateBeginsWithWhatOneNeeds) {
    const TemporaryFolder folder;
    const std::string help = run_command("fretwork calibrate --help", folder.path()).out;
    const auto place = [&](const char* option) {
        const std::size_t at = help.find(std::string("\n  ") + option + " ");
        EXPECT_NE(at, std::string::npos) << option;
        return at;
    };
    EXPECT_LT(place("--library"), place("--patterns"));
    EXPECT_LT(place("--patterns"), place("--setting"));
    EXPECT_LT(place("--setting"), place("--starts"));
    EXPECT_LT(place("--starts"), place("--optimizer")) << "the longest text comes last";
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

TEST(Help, VersionNamesCommitCompilerAndLibraries) {
    const TemporaryFolder folder;
    const auto outcome = run_command("fretwork --version", folder.path());
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_THAT(outcome.out, testing::MatchesRegex("fretwork [0-9]+\\.[0-9]+\\.[0-9]+\n"
                                                   "commit (release|[0-9a-z.-]+)\n"
                                                   "compiler [A-Za-z]+ [0-9.]+\n"
                                                   "libraries ([A-Za-z0-9-]+ [0-9.]+(, |\n))+"));
    for (const std::string library : {"Boost", "Ceres", "CGAL", "Eigen", "SQLite"})
        EXPECT_THAT(outcome.out, HasSubstr(library + " "));
}

TEST(Help, OfAVerbIsWhatTheVerbHelpPrints) {
    const TemporaryFolder folder;
    for (const std::string verb : {"tile", "library", "case add", "help"}) {
        const auto outcome = run_command("fretwork help " + verb, folder.path());
        EXPECT_EQ(outcome.exit_code, 0) << verb;
        EXPECT_EQ(outcome.out, run_command("fretwork " + verb + " --help", folder.path()).out);
    }
    EXPECT_EQ(run_command("fretwork help", folder.path()).out,
              run_command("fretwork --help", folder.path()).out);
}

TEST(Help, OfAnUnknownVerbNamesTheNearest) {
    const TemporaryFolder folder;
    const auto outcome = run_command("fretwork help simulat", folder.path());
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_THAT(outcome.err, HasSubstr("'simulate'"));
    EXPECT_EQ(run_command("fretwork help tile add", folder.path()).exit_code, 2);
}

TEST(Help, GroupsTheVerbsByTheirPurpose) {
    const TemporaryFolder folder;
    EXPECT_THAT(run_command("fretwork --help", folder.path()).out,
                testing::ContainsRegex("\nPattern library:\n  enumerate (.|\n)*\nSurface:\n  tile (.|\n)*"
                                       "\nMaking and output:\n  export (.|\n)*\nTools:\n  solve "));
}

TEST(Help, IsWhatTheProgramAlonePrints) {
    const TemporaryFolder folder;
    const auto alone = run_command("fretwork", folder.path());
    EXPECT_EQ(alone.exit_code, 2);
    EXPECT_EQ(alone.out, run_command("fretwork --help", folder.path()).out);
}

TEST(Help, MissingArgumentsAreToldWithTheUsage) {
    const TemporaryFolder folder;
    const auto complaint = [&](const std::string& command) {
        const auto outcome = run_command(command, folder.path());
        EXPECT_EQ(outcome.exit_code, 2) << command;
        EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
        return outcome.err;
    };
    EXPECT_EQ(complaint("fretwork compare full.json"),
              "fretwork: reduced is required; usage: fretwork compare full reduced [OPTIONS]\n");
    EXPECT_THAT(complaint("fretwork draw"), HasSubstr("usage: fretwork draw pattern --out FILE [OPTIONS]"));
    EXPECT_THAT(complaint("fretwork simulate p.json"),
                HasSubstr("--out is required; usage: fretwork simulate project --out FILE [OPTIONS]"));
    EXPECT_THAT(complaint("fretwork case"), HasSubstr("usage: fretwork case VERB"));
}

}  // namespace THIS_TEST
}  // namespace fretwork::app
