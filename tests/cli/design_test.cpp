// SPDX-License-Identifier: GPL-3.0-or-later
// fretwork design, as a person runs it.
#include "cli/command.hpp"
#include "support.hpp"

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
                            "patterns", "seconds", "solutions", "seed"})
        EXPECT_THAT(done.out, HasSubstr("\"" + std::string(key) + "\"")) << key;
    const auto designed = simulation::read_project(folder_.path() / "d.json");
    for (const tiling::Tile& tile : designed.tessellation.tiles) EXPECT_GE(tile.pattern, 0);
    EXPECT_EQ(run("fretwork simulate d.json --case cantilever --out r.json").exit_code, 0);
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
    refused("--target t.json --palette 0-6 --free width", "expected factor, prescribed");
    refused("--target t.json --palette 0-6 --symmetry glide", "mirror:x");
    refused("--target t.json --palette 0-6 --max-utilization 0.5", "strength");
    refused("--target t.json --palette 0-6 --case rain", "rain");
}

}  // namespace THIS_TEST
}  // namespace fretwork::app
