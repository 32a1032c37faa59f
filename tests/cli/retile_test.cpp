// SPDX-License-Identifier: GPL-3.0-or-later
// fretwork retile, as a person runs it.
#include "cli/refusal.hpp"
#include "support.hpp"

#include <fretwork/base/internal/json_text.hpp>
#include <fretwork/simulation/project/project_file.hpp>
#include <fretwork/tiling/painting/tile_choice.hpp>

#include <algorithm>

namespace fretwork::app {
namespace THIS_TEST {

using test::expect_refused;
using test::Outcome;
using test::run_command;
using test::TemporaryFolder;
using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

/// Held at its left side and at two nodes by number, loaded at its right side.
constexpr const char* kCase = R"({"format": "fretwork/load-case/1", "name": "tip", "description": "",
 "supports": [{"side": "left", "fixed": ["ux", "uy", "uz", "rx", "ry", "rz"]},
              {"nodes": [0, 1], "fixed": ["uz"]}],
 "loads": [{"side": "right", "force": [0, 0, -0.001], "amount": "total"}]})";

class RetileCommand : public testing::Test {
  protected:
    void SetUp() override {
        folder_.file("tip.json", kCase);
        ASSERT_EQ(run("fretwork tile experiments/outlines/specimen.svg --edge-length 30mm --patterns "
                      "0-1+1-6 --out p.json && fretwork case add p.json tip.json")
                      .exit_code,
                  0);
    }
    [[nodiscard]] Outcome run(const std::string& command) const {
        return run_command(command, folder_.path());
    }
    [[nodiscard]] simulation::Project project(const std::string& name) const {
        return simulation::read_project(folder_.path() / name);
    }
    /// Exit 2 with one line, and nothing is written.
    void expect_refusal(const std::string& options, const std::string& problem) const {
        expect_refused("fretwork retile p.json --out new.json " + options, folder_.path(), problem);
    }
    TemporaryFolder folder_;
};

TEST_F(RetileCommand, KeepsWhatHasAPlaceAndCountsWhatHasNone) {
    const std::string before = base::read_text_file(folder_.path() / "p.json");
    const Outcome done = run("fretwork retile p.json --edge-length 20mm --out new.json");
    ASSERT_EQ(done.exit_code, 0) << done.err;
    EXPECT_THAT(done.err, HasSubstr("left out of the load cases: 1 support;"));
    const simulation::Project coarse = project("p.json");
    const simulation::Project fine = project("new.json");
    EXPECT_GT(fine.tessellation.tiles.size(), 3 * coarse.tessellation.tiles.size() / 2);
    for (const tiling::Tile& tile : fine.tessellation.tiles) EXPECT_GE(tile.pattern, 0);
    EXPECT_EQ(fine.outline.boundary, coarse.outline.boundary);
    EXPECT_EQ(fine.setting, coarse.setting);
    ASSERT_EQ(fine.load_cases.size(), 1U);
    EXPECT_EQ(fine.load_cases.front().supports, std::vector{coarse.load_cases.front().supports.front()});
    EXPECT_EQ(fine.load_cases.front().loads, coarse.load_cases.front().loads);
    EXPECT_EQ(run("fretwork simulate new.json --model condensed --out r.json").exit_code, 0);
    EXPECT_EQ(base::read_text_file(folder_.path() / "p.json"), before);
}

TEST_F(RetileCommand, PrintsJsonForPrograms) {
    const Outcome done = run("fretwork retile p.json --edge-length 20mm --json --out new.json");
    ASSERT_EQ(done.exit_code, 0) << done.err;
    const base::Json json = base::Json::parse(done.out);
    EXPECT_EQ(json["tiles"], project("new.json").tessellation.tiles.size());
    EXPECT_NEAR(json["mean_side"].get<double>(), 0.02, 0.002);
    EXPECT_EQ(json["patterns"], 1);
    EXPECT_EQ(json["unpainted_tiles"], 0);
    EXPECT_EQ(json["dropped"], (base::Json{{"supports", 1}, {"loads", 0}, {"prescribed", 0}}));
    EXPECT_EQ(json["load_cases_kept"], base::Json::array({"tip"}));
}

TEST_F(RetileCommand, KeepsTheSizeOfTilesWhereOnlyTheAngleIsAnother) {
    const Outcome done = run("fretwork retile p.json --angle 20deg --json --out new.json");
    ASSERT_EQ(done.exit_code, 0) << done.err;
    EXPECT_NEAR(base::Json::parse(done.out)["mean_side"].get<double>(), 0.03, 0.003);
    EXPECT_NE(project("new.json").tessellation.vertices, project("p.json").tessellation.vertices);
}

TEST_F(RetileCommand, PaintsWhereItIsAskedTo) {
    const Outcome done =
        run("fretwork retile p.json --edge-length 20mm --patterns field:u --palette 0-1+1-6,0-5+5-6 --out "
            "new.json");
    ASSERT_EQ(done.exit_code, 0) << done.err;
    const tiling::Tessellation fine = project("new.json").tessellation;
    EXPECT_EQ(tiling::used_patterns(fine).size(), 2U);
    const auto centers = tiling::tile_centers(fine);
    const auto [left, right] = std::ranges::minmax_element(centers, {}, &geometry::Point2::x);
    const auto id_at = [&](auto place) {
        return tiling::pattern_of(fine, tiling::TileIndex(place - centers.begin()))->id;
    };
    EXPECT_EQ(id_at(left), "0-1+1-6");
    EXPECT_EQ(id_at(right), "0-5+5-6");
}

TEST_F(RetileCommand, PaintsAFieldOfTheProjectAgain) {
    const std::string field = "--patterns field:u --palette 0-1+1-6,2-4+4-6,0-5+5-6";
    ASSERT_EQ(run("fretwork paint p.json " + field).exit_code, 0);
    ASSERT_EQ(run("fretwork retile p.json --edge-length 20mm --out again.json").exit_code, 0);
    ASSERT_EQ(run("fretwork retile p.json --edge-length 20mm " + field + " --out said.json").exit_code, 0);
    EXPECT_EQ(base::read_text_file(folder_.path() / "again.json"),
              base::read_text_file(folder_.path() / "said.json"));
    EXPECT_THAT(run("fretwork check again.json").out, HasSubstr("valid fretwork/project/4"));
    ASSERT_EQ(run("fretwork paint p.json --patterns 0-1+1-6").exit_code, 0);
    EXPECT_TRUE(project("p.json").recipes.empty()) << "painted by hand";
}

TEST_F(RetileCommand, LeavesTilesOfAnotherLayoutBareUnlessTheyArePainted) {
    const Outcome bare = run("fretwork retile p.json --layout paper8 --out bare.json");
    ASSERT_EQ(bare.exit_code, 0) << bare.err;
    EXPECT_THAT(bare.err, AllOf(HasSubstr("no tile is painted"), HasSubstr("paper7")));
    EXPECT_EQ(project("bare.json").layout.name(), "paper8");
    EXPECT_THAT(project("bare.json").tessellation.patterns, IsEmpty());
    const Outcome painted =
        run("fretwork retile p.json --layout paper8 --patterns 0-1+1-7 --out painted.json");
    ASSERT_EQ(painted.exit_code, 0) << painted.err;
    EXPECT_THAT(painted.err, Not(HasSubstr("no tile is painted")));
    EXPECT_EQ(run("fretwork check painted.json").exit_code, 0);
}

TEST_F(RetileCommand, RefusesInOneLineAndWritesNothing) {
    expect_refusal("", "retile: needs --edge-length, --angle, --narrow or --layout");
    expect_refusal("--edge-length 20", "--edge-length");
    expect_refusal("--edge-length -1mm", "edge length");
    expect_refusal("--edge-length wide", "--edge-length: 'wide'");
    expect_refusal("--angle steep", "--angle: 'steep'");
    expect_refusal("--narrow widen", "--narrow");
    expect_refusal("--layout paper99", "--layout: ");
    expect_refusal("--angle 0 --patterns 0-99", "--patterns");
    expect_refusal("--angle 0 --palette 0-1+1-6", "--palette");
    expect_refusal("--angle 0 --library none.db", "--library: is for --patterns");
    expect_refusal("--angle 0 --patterns 0-1+1-6 --library none.db", "none.db");
    expect_refused("fretwork retile p.json --angle 0 --out p.json", folder_.path(),
                   "p.json: is read by this command");
}

/// A box that holds a node of the old tiles and none of the new ones.
TEST_F(RetileCommand, NamesTheEntryThatFindsNoNode) {
    const geometry::Point2 node = project("p.json").tessellation.interface_nodes.at(30);
    const auto side = [](double value) { return base::Json(value).dump(); };
    const std::string box = "[" + side(node.x - 1e-6) + ", " + side(node.y - 1e-6) + ", " +
                            side(node.x + 1e-6) + ", " + side(node.y + 1e-6) + "]";
    folder_.file("pin.json", R"({"format": "fretwork/load-case/1", "name": "pin", "description": "",
 "supports": [{"box": )" + box + R"(, "fixed": ["ux", "uy", "uz", "rx", "ry", "rz"]}]})");
    ASSERT_EQ(run("fretwork case add p.json pin.json").exit_code, 0);
    expect_refusal("--edge-length 23mm", "p.json: load case 'pin': /supports/0: ");
}

TEST_F(RetileCommand, ReplacesNoProjectWithOtherLoadCases) {
    ASSERT_EQ(run("fretwork tile experiments/outlines/specimen.svg --edge-length 60mm --out other.json && "
                  "fretwork case add other.json experiments/cases/own_weight.json")
                  .exit_code,
              0);
    const std::string before = base::read_text_file(folder_.path() / "other.json");
    expect_refused("fretwork retile p.json --edge-length 20mm --out other.json", folder_.path(),
                   "other.json: is another project: its load case 'own-weight' would be lost");
    EXPECT_EQ(base::read_text_file(folder_.path() / "other.json"), before);
}

TEST_F(RetileCommand, ReplacesNoProjectWithAnotherOutline) {
    ASSERT_EQ(
        run("fretwork tile experiments/outlines/example_a.svg --edge-length 40mm --out other.json").exit_code,
        0);
    const std::string before = base::read_text_file(folder_.path() / "other.json");
    const Outcome refused = run("fretwork retile p.json --edge-length 20mm --out other.json");
    EXPECT_EQ(refused.exit_code, 2);
    EXPECT_THAT(
        refused.err,
        HasSubstr(
            "other.json: is another project: its outline is not that of p.json; give --out another name"));
    EXPECT_EQ(base::read_text_file(folder_.path() / "other.json"), before);
    ASSERT_EQ(run("fretwork retile p.json --edge-length 25mm --out new.json").exit_code, 0);
    EXPECT_EQ(run("fretwork retile p.json --edge-length 20mm --out new.json").exit_code, 0)
        << "the same outline";
}

/// What is in a pipe is not read, which would wait for ever.
TEST_F(RetileCommand, WritesIntoAPipe) {
    ASSERT_EQ(
        run("mkfifo pipe; timeout 60 cat pipe >got.json & "
            "timeout 60 fretwork retile p.json --edge-length 20mm --out pipe; code=$?; wait; [ $code = 0 ]")
            .exit_code,
        0);
    EXPECT_GT(project("got.json").tessellation.tiles.size(), project("p.json").tessellation.tiles.size());
}

/// The path of a library is relative to the project file.
TEST(ProjectsInOtherFolders, KeepTheirLibrary) {
    const TemporaryFolder folder;
    const auto run = [&](const std::string& command) { return run_command(command, folder.path()); };
    ASSERT_EQ(run("mkdir sub && fretwork enumerate --edges 2..3 --library L.db && fretwork tile "
                  "experiments/outlines/specimen.svg --edge-length 60mm --library L.db --patterns 0-1+1-6 "
                  "--out p.json")
                  .exit_code,
              0);
    for (const std::string words : {"retile p.json --edge-length 50mm", "paint p.json --patterns 0-5+5-6"}) {
        const Outcome done = run("fretwork " + words + " --out sub/q.json");
        ASSERT_EQ(done.exit_code, 0) << done.err;
        const std::string file = (folder.path() / "sub/q.json").string();
        EXPECT_EQ(simulation::read_project(file).library_path, "../L.db") << words;
        const Outcome used = run("fretwork paint sub/q.json --patterns 0-1+1-6");
        EXPECT_EQ(used.exit_code, 0) << used.err;
    }
}

/// What comes through a pipe, or from a shell, lies in no folder: the library is sought from the current one.
TEST(ProjectsFromPipes, KeepTheLibraryOfTheCurrentFolder) {
    const TemporaryFolder folder;
    const auto run = [&](const std::string& command) { return run_command(command, folder.path()); };
    ASSERT_EQ(run("mkdir sub && fretwork enumerate --edges 2..3 --library L.db && fretwork tile "
                  "experiments/outlines/specimen.svg --edge-length 60mm --library L.db --patterns 0-1+1-6 "
                  "--out p.json")
                  .exit_code,
              0);
    for (const std::string words :
         {"retile /dev/stdin --edge-length 50mm --patterns 0-5+5-6", "paint /dev/stdin --patterns 0-5+5-6"}) {
        for (const std::string& line : {"cat p.json | fretwork " + words + " --out sub/q.json",
                                        "fretwork " + words + " --out sub/q.json < p.json"}) {
            const Outcome done = run(line);
            ASSERT_EQ(done.exit_code, 0) << line << "\n" << done.err;
            EXPECT_EQ(simulation::read_project(folder.path() / "sub/q.json").library_path, "../L.db") << line;
        }
    }
}

}  // namespace THIS_TEST
}  // namespace fretwork::app
