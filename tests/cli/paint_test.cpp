// SPDX-License-Identifier: GPL-3.0-or-later
// fretwork paint, as a person runs it.
#include "cli/command.hpp"
#include "support.hpp"

#include <fretwork/simulation/project/painting_recipe.hpp>
#include <fretwork/simulation/project/project_file.hpp>
#include <fretwork/tiling/painting/tile_choice.hpp>

#include <algorithm>
#include <map>

namespace fretwork::app {
namespace THIS_TEST {

using test::Outcome;
using test::run_command;
using test::TemporaryFolder;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

class PaintCommand : public testing::Test {
  protected:
    void SetUp() override {
        ASSERT_EQ(
            run("fretwork tile experiments/outlines/specimen.svg --edge-length 40mm --out p.json").exit_code,
            0);
        ASSERT_EQ(run("fretwork paint p.json --patterns 0-1+1-6").exit_code, 0);
    }
    [[nodiscard]] Outcome run(const std::string& command) const {
        return run_command(command, folder_.path());
    }
    [[nodiscard]] simulation::Project project() const {
        return simulation::read_project(folder_.path() / "p.json");
    }
    /// The pattern of each tile by its id.
    [[nodiscard]] std::vector<std::string> patterns() const {
        const simulation::Project now = project();
        std::vector<std::string> list;
        for (const tiling::Tile& tile : now.tessellation.tiles)
            list.push_back(now.tessellation.patterns.at(static_cast<std::size_t>(tile.pattern)).id);
        return list;
    }
    TemporaryFolder folder_;
};

TEST_F(PaintCommand, KeepsLoadCasesAndPaintsOnlyTheTilesThatAreNamed) {
    ASSERT_EQ(run("fretwork case add p.json experiments/cases/cantilever.json").exit_code, 0);
    const Outcome painted = run("fretwork paint p.json --tiles 2,4-5 --patterns 0-5+5-6");
    ASSERT_EQ(painted.exit_code, 0) << painted.err;
    EXPECT_THAT(painted.out, HasSubstr("load cases kept: 1"));
    const auto now = patterns();
    for (std::size_t t = 0; t < now.size(); ++t)
        EXPECT_EQ(now[t], t == 2 || t == 4 || t == 5 ? "0-5+5-6" : "0-1+1-6") << t;
    EXPECT_EQ(project().load_cases.size(), 1U);
}

TEST_F(PaintCommand, RegionsOfADrawingTakeThePatternOfTheirColour) {
    folder_.file(
        "r.svg",
        R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 2000 2000" width="2000mm" height="2000mm">
<rect x="0" width="100" height="2000" fill="#00f"/></svg>)");
    const Outcome painted = run("fretwork paint p.json --patterns colours:r.svg --palette blue=0-5+5-6");
    ASSERT_EQ(painted.exit_code, 0) << painted.err;
    const auto centers = tiling::tile_centers(project().tessellation);
    const auto now = patterns();
    for (std::size_t t = 0; t < now.size(); ++t)
        EXPECT_EQ(now[t], centers[t].x < 0.1 ? "0-5+5-6" : "0-1+1-6") << t;
    const Outcome refused = run("fretwork paint p.json --patterns colours:r.svg --palette red=0-5+5-6");
    EXPECT_EQ(refused.exit_code, 2);
    EXPECT_THAT(refused.err,
                AllOf(HasSubstr("r.svg: nothing in it is filled with #ff0000"), HasSubstr("#0000ff")));
}

TEST_F(PaintCommand, AFieldGoesFromTheSoftestToTheStiffestPattern) {
    const Outcome painted =
        run("fretwork paint p.json --patterns field:u --palette 0-1+1-6,2-4+4-6,0-5+5-6 --property "
            "bending_stiffness");
    ASSERT_EQ(painted.exit_code, 0) << painted.err;
    const auto now = patterns();
    const auto centers = tiling::tile_centers(project().tessellation);
    // Whichever pattern is the softest, each takes one interval of x.
    std::map<std::string, std::pair<double, double>> reach;
    for (std::size_t t = 0; t < now.size(); ++t) {
        const auto [entry, is_new] = reach.try_emplace(now[t], centers[t].x, centers[t].x);
        entry->second = {std::min(entry->second.first, centers[t].x),
                         std::max(entry->second.second, centers[t].x)};
    }
    ASSERT_GE(reach.size(), 2U);
    for (const auto& [a, of_a] : reach)
        for (const auto& [b, of_b] : reach)
            EXPECT_TRUE(a == b || of_a.second <= of_b.first || of_b.second <= of_a.first) << a << " " << b;
}

TEST_F(PaintCommand, MirroringTwiceChangesNothing) {
    const auto before = patterns();
    ASSERT_EQ(run("fretwork paint p.json --mirror --tiles 1-3").exit_code, 0);
    EXPECT_EQ(patterns()[0], before[0]);
    EXPECT_NE(patterns()[1], before[1]);
    ASSERT_EQ(run("fretwork paint p.json --mirror --tiles 1-3").exit_code, 0);
    EXPECT_EQ(patterns(), before);
}

TEST_F(PaintCommand, AnotherProjectIsWrittenWhereOutSays) {
    const auto before = patterns();
    const Outcome painted = run("fretwork paint p.json --patterns 0-5+5-6 --out new.json");
    ASSERT_EQ(painted.exit_code, 0) << painted.err;
    EXPECT_EQ(patterns(), before);
    const auto written = simulation::read_project(folder_.path() / "new.json");
    EXPECT_EQ(pattern::ids_of(written.tessellation.patterns), std::vector<std::string>{"0-5+5-6"});
}

TEST_F(PaintCommand, PatternsOfAnotherLayoutAreRefusedBeforeAnythingIsWritten) {
    ASSERT_EQ(run("fretwork enumerate --layout spider4 --library l.db && "
                  "fretwork calibrate --library l.db --model condensed")
                  .exit_code,
              0);
    const auto before = patterns();
    const Outcome refused = run("fretwork paint p.json --library l.db --patterns random:1");
    EXPECT_EQ(refused.exit_code, 2);
    EXPECT_THAT(refused.err, AllOf(HasSubstr("spider4"), HasSubstr("paper7")));
    EXPECT_EQ(patterns(), before);
}

TEST_F(PaintCommand, SeveralColoursMayStandForOnePattern) {
    folder_.file(
        "two.svg",
        R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 2000 2000" width="2000mm" height="2000mm">
<rect width="100" height="2000" fill="#00f"/><rect x="100" width="1900" height="2000" fill="red"/></svg>)");
    ASSERT_EQ(run("fretwork tile experiments/outlines/specimen.svg --edge-length 40mm --out q.json "
                  "--patterns colours:two.svg --palette red=0-5+5-6,#00f=0-5+5-6")
                  .exit_code,
              0);
    const auto written = simulation::read_project(folder_.path() / "q.json");
    EXPECT_EQ(pattern::ids_of(written.tessellation.patterns), std::vector<std::string>{"0-5+5-6"});
}

TEST_F(PaintCommand, ColoursMayHaveCommasInBrackets) {
    folder_.file(
        "two.svg",
        R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 2000 2000" width="2000mm" height="2000mm">
<rect width="100" height="2000" fill="#00f"/><rect x="100" width="1900" height="2000" fill="red"/></svg>)");
    const Outcome painted = run(
        "fretwork paint p.json --patterns colours:two.svg --palette 'rgb(255, 0, 0)=0-1+1-6,blue=0-5+5-6'");
    ASSERT_EQ(painted.exit_code, 0) << painted.err;
    const auto centers = tiling::tile_centers(project().tessellation);
    const auto now = patterns();
    for (std::size_t t = 0; t < now.size(); ++t)
        EXPECT_EQ(now[t], centers[t].x < 0.1 ? "0-5+5-6" : "0-1+1-6") << t;
    EXPECT_THAT(run("fretwork paint p.json --patterns colours:two.svg --palette 'rgb(0,0,255=0-1+1-6'").err,
                HasSubstr("--palette: 'rgb(0,0,255' is not a colour"));
}

TEST_F(PaintCommand, AColourHasOnePattern) {
    const auto before = patterns();
    for (const std::string other : {"#f00", "red", "rgb(255,0,0)"}) {
        const Outcome refused = run("fretwork paint p.json --patterns colours:r.svg --palette 'red=0-1+1-6," +
                                    other + "=0-5+5-6'");
        EXPECT_EQ(refused.exit_code, 2) << other;
        EXPECT_THAT(refused.err, HasSubstr("--palette: 'red=0-1+1-6' and '" + other +
                                           "=0-5+5-6' are for one colour, #ff0000"));
    }
    EXPECT_EQ(patterns(), before);
}

TEST_F(PaintCommand, NumbersOfABoxArePartedByCommasOrBlanks) {
    for (const std::string box : {"0,0,1,1", "'0,0 1,1'", "'0 0 1 1'"}) {
        const Outcome painted = run("fretwork paint p.json --patterns 0-5+5-6 --box " + box);
        EXPECT_EQ(painted.exit_code, 0) << box << painted.err;
    }
}

TEST_F(PaintCommand, ACircleTakesTheTilesWhoseMiddleLiesInIt) {
    const Outcome painted = run("fretwork paint p.json --patterns 0-5+5-6 --circle 60mm,50mm,40mm");
    ASSERT_EQ(painted.exit_code, 0) << painted.err;
    const auto centers = tiling::tile_centers(project().tessellation);
    const auto list = patterns();
    for (const tiling::TileIndex tile : centers.indices()) {
        const double dx = centers[tile].x - 0.06;
        const double dy = centers[tile].y - 0.05;
        EXPECT_EQ(list[static_cast<std::size_t>(tile.value)] == "0-5+5-6", dx * dx + dy * dy <= 0.04 * 0.04)
            << tile.value;
    }
    EXPECT_GT(std::ranges::count(list, std::string("0-5+5-6")), 0);
    for (const std::string bad : {"0,0", "0,0,0", "0,0,-10mm", "0,0,nan", "0,0,1,1"}) {
        const Outcome refused = run("fretwork paint p.json --patterns 0-5+5-6 --circle " + bad);
        EXPECT_EQ(refused.exit_code, 2) << bad;
        EXPECT_THAT(refused.err, AllOf(testing::StartsWith("fretwork: "), HasSubstr("--circle"))) << bad;
        EXPECT_EQ(std::ranges::count(refused.err, '\n'), 1) << refused.err;
    }
}

TEST_F(PaintCommand, NoTileThereIsExitOneAndChangesNothing) {
    const auto before = patterns();
    const Outcome none = run("fretwork paint p.json --box 9,9,10,10 --patterns 0-5+5-6");
    EXPECT_EQ(none.exit_code, 1);
    EXPECT_EQ(patterns(), before);
}

TEST_F(PaintCommand, AnImagesGreyChoosesPatternsFromLightToDark) {
    // 16 pixels of grey in a row, from white to black.
    ASSERT_EQ(run("echo "
                  "'iVBORw0KGgoAAAANSUhEUgAAABAAAAABCAAAAADyEnGDAAAAGklEQVR4nGP4/"
                  "+7umd2rZnaUp4W6GCsJMgAAWmEH+SROr2sAAAAASUVORK5CYII=' | base64 -d > ramp.png")
                  .exit_code,
              0);
    const Outcome painted = run("fretwork paint p.json --patterns image:ramp.png --palette 0-1+1-6,0-5+5-6");
    ASSERT_EQ(painted.exit_code, 0) << painted.err;
    const auto centers = tiling::tile_centers(project().tessellation);
    const auto list = patterns();
    double last_light = -1e9;
    double first_dark = 1e9;
    for (std::size_t t = 0; t < list.size(); ++t) {
        if (list[t] == "0-1+1-6") last_light = std::max(last_light, centers[t].x);
        if (list[t] == "0-5+5-6") first_dark = std::min(first_dark, centers[t].x);
    }
    EXPECT_LT(last_light, first_dark);
    EXPECT_GT(last_light, 0.0);
    ASSERT_EQ(
        run("fretwork paint p.json --patterns image:ramp.png --palette 0-1+1-6,0-5+5-6 --dither").exit_code,
        0);
    EXPECT_NE(patterns(), list) << "dithered, both are mixed where it is grey";
}

TEST_F(PaintCommand, ADrawingTooLargeToBeKeptIsToldByEachCommandThatPaints) {
    const auto drawing = [&](const std::string& name, const std::string& width, std::size_t blanks) {
        folder_.file(name,
                     R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 2000 2000" width="2000mm" )"
                     R"(height="2000mm"><rect height="2000" fill="red" width=")" +
                         width + "\"/>" + std::string(blanks, ' ') + "</svg>");
    };
    drawing("small.svg", "2000", 0);
    drawing("large.svg", "2000", simulation::kLargestKeptFile);
    drawing("small_half.svg", "100", 0);
    drawing("large_half.svg", "100", simulation::kLargestKeptFile);
    ASSERT_EQ(run("fretwork tile experiments/outlines/specimen.svg --edge-length 40mm --patterns random:1 "
                  "--palette 0-1+1-6,0-5+5-6 --out chance.json")
                  .exit_code,
              0);
    for (const std::string command :
         {"paint p.json", "retile p.json --edge-length 50mm --out q.json",
          "retile chance.json --edge-length 50mm --out q.json",
          "tile experiments/outlines/specimen.svg --edge-length 40mm --out r.json"}) {
        for (const std::string file :
             {"small.svg", "large.svg", "small_half.svg", "large_half.svg", "large.svg"}) {
            SCOPED_TRACE(command + " " + file);
            const Outcome done =
                run("fretwork " + command + " --palette red=0-5+5-6 --patterns colours:" + file);
            EXPECT_EQ(done.exit_code, 0) << done.err;
            const auto told = HasSubstr("does not keep " + file + ", which has more than 4 MiB");
            if (file.starts_with("large"))
                EXPECT_THAT(done.err, told);
            else
                EXPECT_THAT(done.err, Not(HasSubstr("does not keep")));
        }
    }
}

TEST_F(PaintCommand, OptionsThatThePatternsDoNotGoWithAreRefused) {
    for (const std::string bad :
         {"", "--patterns 0-1+1-6 --dither", "--patterns 0-1+1-6 --palette 0-5+5-6",
          "--patterns field:u --palette 0-1+1-6,0-5+5-6 --property stiffness",
          "--patterns random:1 --palette 0-1+1-6=0", "--patterns colours:r.svg",
          "--patterns field:u --palette 0-1+1-6 --range 0,1", "--patterns image:none.png --palette 0-1+1-6",
          "--patterns 0-1+1-6 --box 0,0,1", "--patterns 0-1+1-6 --polygon 0,0,1,1"}) {
        const Outcome refused = run("fretwork paint p.json " + bad);
        EXPECT_EQ(refused.exit_code, 2) << bad << ": " << refused.out;
        EXPECT_THAT(refused.err, testing::StartsWith("fretwork: ")) << bad;
    }
}

TEST_F(PaintCommand, TellsOfBarsThatOverlap) {
    EXPECT_EQ(run("fretwork paint p.json --patterns 0-1+1-6").err, "");
    EXPECT_THAT(run("fretwork paint p.json --patterns 0-1+1-6 --clearance 30mm").err,
                AllOf(HasSubstr("pairs of bars"), HasSubstr("in tiles 0, 1")));
}

TEST_F(PaintCommand, DrawingsShowNumbersOfTilesAndNodesWhereAskedFor) {
    ASSERT_EQ(
        run("fretwork tile experiments/outlines/specimen.svg --edge-length 40mm --out q.json").exit_code, 0);
    ASSERT_EQ(run("fretwork export q.json --labels tiles,nodes --to q.svg").exit_code, 0)
        << "a project that is not painted can be drawn";
    const std::string text = base::read_text_file(folder_.path() / "q.svg");
    EXPECT_THAT(text, AllOf(HasSubstr("numbers-of-tiles"), HasSubstr("numbers-of-interface-nodes"),
                            HasSubstr("tile 3: not painted")));
    ASSERT_EQ(run("fretwork draw 0-1+1-6 2-4+4-6 --out d.svg").exit_code, 0);
    EXPECT_THAT(base::read_text_file(folder_.path() / "d.svg"),
                AllOf(HasSubstr("2-4+4-6"), HasSubstr("0-1+1-6")));
}

}  // namespace THIS_TEST
}  // namespace fretwork::app
