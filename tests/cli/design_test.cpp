// SPDX-License-Identifier: GPL-3.0-or-later
// fretwork design, as a person runs it.
#include "cli/command.hpp"
#include "support.hpp"

#include <fretwork/base/files/file.hpp>
#include <fretwork/base/internal/json_text.hpp>
#include <fretwork/simulation/project/project_file.hpp>

namespace fretwork::app {
namespace THIS_TEST {

using test::Outcome;
using test::run_command;
using test::TemporaryFolder;
using testing::AllOf;
using testing::HasSubstr;

class DesignCommand : public testing::Test {
  protected:
    void SetUp() override {
        ASSERT_EQ(
            run("fretwork tile experiments/outlines/specimen.svg --edge-length 40mm --out p.json").exit_code,
            0);
        ASSERT_EQ(run("fretwork case add p.json experiments/cases/cantilever.json").exit_code, 0);
        folder_.file("t.json", R"({"format": "fretwork/target/1", "goals": [
            {"select": {"side": "right"}, "displacement": [null, null, -0.003]}]})");
    }
    [[nodiscard]] Outcome run(const std::string& command) const {
        return run_command(command, folder_.path());
    }
    TemporaryFolder folder_;
};

TEST_F(DesignCommand, WritesAPaintedProjectAndWhatItReaches) {
    const Outcome done =
        run("fretwork design p.json --target t.json --palette 0-1+1-6,0-6,0-1+1-5+1-6+5-6 --free factor "
            "--json --out d.json");
    ASSERT_LE(done.exit_code, 1) << done.err;
    for (const char* key : {"error_mean", "error_largest", "error_best_uniform", "error_relaxed", "bound",
                            "patterns", "seconds", "solutions", "seed", "stable_from_flat", "width",
                            "reach_of_ten_loads", "curvatures_outside", "utilization_error", "warnings"})
        EXPECT_THAT(done.out, HasSubstr("\"" + std::string(key) + "\"")) << key;
    const auto designed = simulation::read_project(folder_.path() / "d.json");
    for (const tiling::Tile& tile : designed.tessellation.tiles) EXPECT_GE(tile.pattern, 0);
    EXPECT_EQ(run("fretwork simulate d.json --case cantilever --out r.json").exit_code, 0);
}

TEST_F(DesignCommand, PrintsEveryWarningForPeopleAndForPrograms) {
    folder_.file("far.json", R"({"format": "fretwork/target/1", "goals": [
        {"select": {"side": "right"}, "displacement": [null, null, -0.3]}]})");
    const Outcome done =
        run("fretwork design p.json --target far.json --palette 0-1+1-6,0-6 --json --out d.json");
    ASSERT_EQ(done.exit_code, 1) << done.err;
    const base::Json warnings = base::Json::parse(done.out)["warnings"];
    ASSERT_FALSE(warnings.empty());
    EXPECT_THAT(warnings[0].get<std::string>(), HasSubstr("the target asks for"));
    EXPECT_EQ(std::ranges::count(done.err, '\n'), std::ssize(warnings)) << done.err;
    for (const base::Json& warning : warnings)
        EXPECT_THAT(done.err, HasSubstr("fretwork: " + warning.get<std::string>()));
}

/// Bad input is one line with its place, exit 2, and nothing is written.
TEST_F(DesignCommand, RefusesBadInputInOneLine) {
    folder_.file("far.json", R"({"format": "fretwork/target/1", "goals": [
        {"nodes": [99999], "displacements": [[0, 0, 0.01]]}]})");
    const auto refused = [&](const std::string& options, const std::string& problem) {
        const Outcome outcome = run("fretwork design p.json --out d.json " + options);
        EXPECT_EQ(outcome.exit_code, 2) << options;
        EXPECT_THAT(outcome.err, HasSubstr(problem)) << options;
        EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
        EXPECT_FALSE(std::filesystem::exists(folder_.path() / "d.json"));
    };
    refused("--target far.json --palette 0-6", "far.json: /goals/0: there is no interface node 99999");
    refused("--target none.json --palette 0-6", "none.json");
    refused("--target t.json --palette 0-99", "--palette");
    refused("--target t.json --palette sample:0", "sample:N");
    refused("--target t.json --palette library", "library");
    refused("--target t.json --palette 0-6 --keep 3-x", "--keep");
    refused("--target t.json --palette 0-6 --free weight", "expected factor, prescribed, width, thickness");
    refused("--target t.json --palette 0-6 --max-mass -1",
            "--max-mass: '-1' is not a number above zero; without the option there is no limit");
    for (const char* limit : {"--max-mass", "--max-utilization", "--seconds"})
        refused(std::string("--target t.json --palette 0-6 ") + limit + " 0",
                std::string(limit) + ": '0' is not a number above zero");
    refused("--target t.json --palette 0-6 --solutions 0", "--solutions");
    refused("--target t.json --palette 0-6 --max-mass nan", "--max-mass: 'nan'");
    refused("--target t.json --palette 0-6 --seconds nan", "--seconds: 'nan'");
    refused("--target t.json --palette 0-6 --clearance -1mm", "--clearance");
    refused("--target t.json --palette 0-6 --report page.txt", "page.txt");
    refused("--target t.json --palette 0-6 --symmetry glide", "mirror:x");
    refused("--target t.json --palette 0-6 --max-utilization 0.5", "strength");
    refused("--target t.json --palette 0-6 --case rain", "--case: unknown load case 'rain'");
    folder_.file("named.json", R"({"format": "fretwork/target/1", "goals": [
        {"select": {"side": "right"}, "displacement": [0, 0, -0.003], "case": "rain"}]})");
    refused("--target named.json --palette 0-6", "named.json: /goals/0/case: unknown load case 'rain'");
    folder_.file("both.json", R"({"format": "fretwork/target/1", "goals": [
        {"nodes": [3], "displacements": [[0, 0, 0.01]]}, {"nodes": [3], "displacements": [[0, 0, 0.02]]}]})");
    refused("--target both.json --palette 0-6", "both.json: /goals/1: wants uz = 20 mm of node 3");
}

TEST_F(DesignCommand, RefusesToReplaceAProjectWithAnotherOutline) {
    ASSERT_EQ(
        run("fretwork tile experiments/outlines/example_a.svg --edge-length 40mm --out other.json").exit_code,
        0);
    const std::string before = base::read_text_file(folder_.path() / "other.json");
    const Outcome outcome = run("fretwork design p.json --target t.json --palette 0-6 --out other.json");
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_THAT(outcome.err, HasSubstr("other.json: is another project: its outline is not that of p.json"));
    EXPECT_EQ(base::read_text_file(folder_.path() / "other.json"), before);
}

/// What another project holds is not lost.
TEST_F(DesignCommand, RefusesToReplaceAProjectWithOtherLoadCases) {
    ASSERT_EQ(
        run("fretwork tile experiments/outlines/specimen.svg --edge-length 40mm --out other.json").exit_code,
        0);
    ASSERT_EQ(run("fretwork case add other.json experiments/cases/own_weight.json").exit_code, 0);
    const Outcome outcome = run("fretwork design p.json --target t.json --palette 0-6 --out other.json");
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_THAT(outcome.err, AllOf(HasSubstr("other.json: is another project"), HasSubstr("would be lost")));
    EXPECT_EQ(simulation::read_project(folder_.path() / "other.json").load_cases.size(), 1U);
}

TEST_F(DesignCommand, WritesAPageOfTheDesign) {
    const Outcome done =
        run("fretwork design p.json --target t.json --palette 0-1+1-6,0-6,0-1+1-5+1-6+5-6 --free "
            "factor,thickness "
            "--solutions 20 --out d.json --report page.html");
    ASSERT_LE(done.exit_code, 1) << done.err;
    EXPECT_THAT(done.out, HasSubstr("mm thick"));
    EXPECT_THAT(base::read_text_file(folder_.path() / "page.html"), HasSubstr("id=\"data\">{"));
}

/// One pattern is the single pattern that it is compared with, whatever else is free.
TEST_F(DesignCommand, ASinglePatternIsNoSuccess) {
    const Outcome done =
        run("fretwork design p.json --target t.json --palette 0-1+1-6 --free factor --out d.json");
    EXPECT_EQ(done.exit_code, 1);
    EXPECT_THAT(done.out, HasSubstr("1 pattern,"));
}

}  // namespace THIS_TEST
}  // namespace fretwork::app
