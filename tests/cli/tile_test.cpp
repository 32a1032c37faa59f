// SPDX-License-Identifier: GPL-3.0-or-later
// fretwork tile, as a person runs it.
#include "cli/command.hpp"
#include "support.hpp"

namespace fretwork::app {
namespace THIS_TEST {

using test::Outcome;
using test::run_command;
using test::TemporaryFolder;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

constexpr const char* kTile =
    "fretwork tile experiments/outlines/specimen.svg --patterns 0-1+1-6 --out p.json";

TEST(TileCommand, KeepsTheLoadCasesOfAProjectThatIsThere) {
    const TemporaryFolder folder;
    ASSERT_EQ(run_command(std::string(kTile) + " --edge-length 30mm", folder.path()).exit_code, 0);
    const std::string add = "fretwork case add p.json experiments/cases/cantilever.json";
    ASSERT_EQ(run_command(add, folder.path()).exit_code, 0);
    const Outcome again = run_command(std::string(kTile) + " --edge-length 40mm", folder.path());
    ASSERT_EQ(again.exit_code, 0) << again.err;
    EXPECT_THAT(again.out, HasSubstr("the project keeps its load cases: 1"));
    EXPECT_THAT(run_command("fretwork case list p.json", folder.path()).out, HasSubstr("cantilever"));
}

TEST(TileCommand, NamesTheFileOfAnOutlineThatCannotBeTiled) {
    const TemporaryFolder folder;
    folder.file(
        "needle.json",
        R"({"format": "fretwork/outline/1", "boundary": [[0, 0], [0.4, 0], [0.4, 0.3], [0.2001, 0.3], [0.2, 0.5], [0.1999, 0.3], [0, 0.3]]})");
    folder.file("speck.json",
                R"({"format": "fretwork/outline/1", "boundary": [[0, 0], [0.001, 0], [0, 0.001]]})");
    folder.file("country.json",
                R"({"format": "fretwork/outline/1", "boundary": [[0, 0], [4e5, 0], [0, 4e5]]})");
    for (const std::string name : {"needle.json", "speck.json", "country.json"}) {
        const Outcome refused = run_command("fretwork tile " + name + " --out p.json", folder.path());
        EXPECT_EQ(refused.exit_code, 2) << name;
        EXPECT_THAT(refused.err, testing::StartsWith("fretwork: " + name + ": ")) << name;
    }
    const Outcome size =
        run_command("fretwork tile speck.json --edge-length 1e-300mm --out p.json", folder.path());
    EXPECT_EQ(size.exit_code, 2);
    EXPECT_THAT(size.err, Not(HasSubstr("speck.json"))) << "what is wrong is the edge length";
}

TEST(TileCommand, ScalesTheOutlineToAWidth) {
    const TemporaryFolder folder;
    const std::string tile = std::string(kTile) + " --width ";
    const Outcome wide = run_command(tile + "600mm --edge-length 40mm", folder.path());
    ASSERT_EQ(wide.exit_code, 0) << wide.err;
    EXPECT_THAT(wide.out, HasSubstr("outline of 600 x "));
    EXPECT_THAT(run_command(tile + "600", folder.path()).err, HasSubstr("did you mean 600mm?"));
    for (const char* bad : {"0", "-1mm", "wide", "inf", "nan", "infmm"}) {
        const Outcome refused = run_command(tile + bad, folder.path());
        EXPECT_EQ(refused.exit_code, 2) << bad;
        EXPECT_THAT(refused.err, AllOf(HasSubstr("--width: '" + std::string(bad) + "' is not"),
                                       Not(HasSubstr("did you mean"))));
    }
}

TEST(TileCommand, CountsThePatternsThatTilesHave) {
    const TemporaryFolder folder;
    const Outcome few = run_command(
        "fretwork tile experiments/outlines/specimen.svg --edge-length 60mm --out p.json --patterns field:0 "
        "--palette 0-1+1-6,2-4+4-6,0-5+5-6",
        folder.path());
    ASSERT_EQ(few.exit_code, 0) << few.err;
    EXPECT_THAT(few.out, HasSubstr(" 1 pattern in use"));
    const Outcome drawn = run_command("fretwork export p.json --to p.svg", folder.path());
    ASSERT_EQ(drawn.exit_code, 0) << drawn.err;
}

TEST(TileCommand, KeepsTheFacesOfAMesh) {
    const TemporaryFolder folder;
    folder.file("mesh.obj",
                "v 0 0 0\nv 0.02 0 0\nv 0.02 0.02 0\nv 0 0.02 0\nv 0.04 0 0\nf 1 2 3 4\nf 2 5 3\n");
    const Outcome kept =
        run_command("fretwork tile mesh.obj --keep-mesh --patterns 0-1+1-6 --out p.json", folder.path());
    ASSERT_EQ(kept.exit_code, 0) << kept.err;
    EXPECT_THAT(kept.out, HasSubstr("2 tiles, 6 interface nodes"));
    const Outcome refused = run_command(
        "fretwork tile experiments/outlines/specimen.svg --keep-mesh --out q.json", folder.path());
    EXPECT_EQ(refused.exit_code, 2);
    EXPECT_THAT(refused.err, HasSubstr("a mesh is an .obj, .ply or .off file"));
}

TEST(TileCommand, SaysWhatItDoesWhereTheOutlineIsNarrow) {
    const TemporaryFolder folder;
    folder.file(
        "band.json",
        R"({"format": "fretwork/outline/1", "boundary": [[0, 0], [0.5, 0], [0.5, 0.02], [0, 0.02]]})");
    const Outcome refined = run_command("fretwork tile band.json --out p.json", folder.path());
    ASSERT_EQ(refined.exit_code, 0) << refined.err;
    EXPECT_THAT(refined.out, HasSubstr("100 % of the tiles are smaller"));
    const Outcome refused =
        run_command("fretwork tile band.json --narrow refuse --out q.json", folder.path());
    EXPECT_EQ(refused.exit_code, 2);
    EXPECT_THAT(refused.err,
                AllOf(HasSubstr("band.json: the outline is 0.02 m wide near"), HasSubstr("work")));
}

TEST(TileCommand, LaysRowsOfTilesAtAnAngle) {
    const TemporaryFolder folder;
    const std::string tile =
        "fretwork tile experiments/outlines/specimen.svg --edge-length 15mm --json --angle ";
    const auto project_at = [&](const std::string& angle) {
        const Outcome tiled = run_command(tile + angle + " --out p.json", folder.path());
        EXPECT_EQ(tiled.exit_code, 0) << tiled.err;
        return base::read_text_file(folder.path() / "p.json");
    };
    const std::string level = project_at("0");
    EXPECT_NE(project_at("20deg"), level);
    EXPECT_EQ(project_at("0rad"), level);
    const Outcome refused = run_command(tile + "steep --out q.json", folder.path());
    EXPECT_EQ(refused.exit_code, 2);
    EXPECT_THAT(refused.err, AllOf(HasSubstr("--angle"), HasSubstr("steep")));
}

TEST(TileCommand, KeepsTheLibraryOfAProjectThatIsThere) {
    const TemporaryFolder folder;
    const std::string tile = "fretwork tile experiments/outlines/specimen.svg --edge-length ";
    ASSERT_EQ(run_command("mkdir sub && fretwork enumerate --edges 2..3 --library L.db && " + tile +
                              "60mm --library L.db --patterns 0-1+1-6 --out sub/p.json",
                          folder.path())
                  .exit_code,
              0);
    const Outcome again = run_command(tile + "50mm --out sub/p.json", folder.path());
    ASSERT_EQ(again.exit_code, 0) << again.err;
    EXPECT_THAT(again.out, HasSubstr("the project keeps its library: ../L.db"));
    EXPECT_THAT(base::read_text_file(folder.path() / "sub/p.json"), HasSubstr("\"path\": \"../L.db\""));
    const Outcome other = run_command(tile + "50mm --layout doors6 --out sub/p.json", folder.path());
    EXPECT_EQ(other.exit_code, 2) << "patterns of another layout are not in the library";
}

/// A load case that needs node 150: more than tiles of 60 mm have, fewer than tiles of 30 mm.
constexpr const char* kNodeCase = R"({"format": "fretwork/load-case/1", "name": "corner", "description": "",
 "supports": [{"nodes": [150], "fixed": ["ux", "uy", "uz", "rx", "ry", "rz"]}]})";

TEST(TileCommand, RefusesALoadCaseThatNoLongerFitsAndLeavesTheProject) {
    const TemporaryFolder folder;
    folder.file("corner.json", kNodeCase);
    ASSERT_EQ(run_command(std::string(kTile) + " --edge-length 20mm", folder.path()).exit_code, 0);
    const Outcome added = run_command("fretwork case add p.json corner.json", folder.path());
    ASSERT_EQ(added.exit_code, 0) << added.err;
    const std::string before = base::read_text_file(folder.path() / "p.json");
    const Outcome refused = run_command(std::string(kTile) + " --edge-length 60mm", folder.path());
    EXPECT_EQ(refused.exit_code, 2);
    EXPECT_THAT(refused.err,
                AllOf(HasSubstr("load case 'corner'"), HasSubstr("/supports/0"), HasSubstr("150")));
    EXPECT_EQ(base::read_text_file(folder.path() / "p.json"), before);
}

TEST(TileCommand, SaysThatNodesPickedByNumberLieElsewhere) {
    const TemporaryFolder folder;
    folder.file("corner.json", kNodeCase);
    const std::string tile_20 = std::string(kTile) + " --edge-length 20mm";
    ASSERT_EQ(run_command(tile_20, folder.path()).exit_code, 0);
    ASSERT_EQ(run_command("fretwork case add p.json corner.json", folder.path()).exit_code, 0);
    EXPECT_THAT(run_command(tile_20, folder.path()).err, Not(HasSubstr("by number")));
    EXPECT_THAT(run_command(std::string(kTile) + " --edge-length 15mm", folder.path()).err,
                HasSubstr("1 of the load cases kept select interface nodes or tiles by number"));
}

TEST(TileCommand, SaysThatLoadsOnTilesOrAreasOfNodesByNumberLieElsewhere) {
    for (const std::string where : {R"("tiles")", R"("nodes")"}) {
        const TemporaryFolder folder;
        folder.file("snow.json", R"({"format": "fretwork/load-case/4", "name": "snow",
            "loads": [{)" + where + R"(: [0, 1, 2], "per_area": [0, 0, -5]}]})");
        const std::string tile_20 = std::string(kTile) + " --edge-length 20mm";
        ASSERT_EQ(run_command(tile_20, folder.path()).exit_code, 0);
        ASSERT_EQ(run_command("fretwork case add p.json snow.json", folder.path()).exit_code, 0) << where;
        EXPECT_THAT(run_command(tile_20, folder.path()).err, Not(HasSubstr("by number"))) << where;
        EXPECT_THAT(run_command(std::string(kTile) + " --edge-length 15mm", folder.path()).err,
                    HasSubstr("1 of the load cases kept select interface nodes or tiles by number"))
            << where;
    }
}

TEST(TileCommand, RefusesAPaletteThatNothingChoosesFrom) {
    const TemporaryFolder folder;
    const std::string tile = "fretwork tile experiments/outlines/specimen.svg --palette 0-1+1-6 --out p.json";
    for (const std::string patterns : {"", " --patterns 0-1+1-6"}) {
        const Outcome outcome = run_command(tile + patterns, folder.path());
        EXPECT_EQ(outcome.exit_code, 2);
        EXPECT_THAT(outcome.err, AllOf(HasSubstr("--palette"), HasSubstr("random:SEED")));
        EXPECT_FALSE(std::filesystem::exists(folder.path() / "p.json"));
    }
}

/// Two squares of 200 and 150 mm with their tops on one line, and a word.
constexpr const char* kTwoParts = R"(<svg width="400mm" height="200mm" viewBox="0 0 400 200"><text>A</text>
 <path d="M0 0H200V200H0Z M250 0H400V150H250Z"/></svg>)";

TEST(TileCommand, TellsTheSizeOfWhatItReadAndWhatItLeftOut) {
    const TemporaryFolder folder;
    folder.file("two.svg", kTwoParts);
    const Outcome tiled = run_command("fretwork tile two.svg --edge-length 30mm --out p.json", folder.path());
    ASSERT_EQ(tiled.exit_code, 0) << tiled.err;
    EXPECT_THAT(tiled.out, HasSubstr("outline of 200 x 200 mm\n"));
    EXPECT_EQ(tiled.err, "fretwork: two.svg: 1 text left out; part 1 of 2 taken, the largest\n");
    const Outcome other =
        run_command("fretwork tile two.svg --part 2 --edge-length 30mm --out p.json", folder.path());
    EXPECT_THAT(other.out, HasSubstr("outline of 150 x 150 mm\n"));
    const Outcome third =
        run_command("fretwork tile two.svg --part 3 --edge-length 30mm --out p.json", folder.path());
    EXPECT_EQ(third.exit_code, 2);
    EXPECT_THAT(third.err, HasSubstr("'3' is none of largest, all, 1 .. 2"));
}

TEST(TileCommand, AllPartsAreOneSurfaceFromTheTilingToTheDrawing) {
    const TemporaryFolder folder;
    folder.file("two.svg", kTwoParts);
    folder.file("sag.json", R"({"format": "fretwork/load-case/1", "name": "sag", "description": "",
 "supports": [{"side": "top", "fixed": ["ux", "uy", "uz", "rx", "ry", "rz"]}],
 "loads": [{"side": "right", "force": [0, 0, -0.001], "amount": "total"}]})");
    const Outcome tiled = run_command(
        "fretwork tile two.svg --part all --edge-length 30mm --patterns 0-1+1-6 --out p.json", folder.path());
    ASSERT_EQ(tiled.exit_code, 0) << tiled.err;
    EXPECT_THAT(tiled.out, HasSubstr("outline of 400 x 200 mm, 2 parts\n"));
    const std::string project = base::read_text_file(folder.path() / "p.json");
    EXPECT_THAT(project, AllOf(HasSubstr("fretwork/project/3"), HasSubstr("\"further_parts\"")));
    ASSERT_EQ(run_command("fretwork case add p.json sag.json", folder.path()).exit_code, 0);
    const Outcome solved = run_command("fretwork simulate p.json --out r.json", folder.path());
    EXPECT_EQ(solved.exit_code, 0) << solved.err;
    EXPECT_EQ(run_command("fretwork export p.json --result r.json --to p.svg", folder.path()).exit_code, 0);
}

}  // namespace THIS_TEST
}  // namespace fretwork::app
