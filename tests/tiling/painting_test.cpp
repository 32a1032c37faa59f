// SPDX-License-Identifier: GPL-3.0-or-later
#include "support.hpp"

#include <fretwork/tiling/painting/painting.hpp>

#include <algorithm>
#include <limits>

namespace fretwork::tiling {
namespace THIS_TEST {

using test::complaint_of;
using test::TemporaryFolder;
using testing::AllOf;
using testing::Each;
using testing::ElementsAre;
using testing::HasSubstr;

pattern::NodeLayout paper_layout() {
    return pattern::find_node_layout("paper7");
}

Tessellation blank(std::size_t tiles) {
    Tessellation tessellation;
    tessellation.layout = "paper7";
    tessellation.tiles.resize(tiles);
    return tessellation;
}

std::vector<int> colours(const Tessellation& tessellation) {
    std::vector<int> list;
    for (const Tile& tile : tessellation.tiles) list.push_back(tile.pattern);
    return list;
}

/// Patterns of which only the names count.
std::vector<pattern::NamedPattern> named(const std::vector<std::string>& ids) {
    std::vector<pattern::NamedPattern> patterns;
    for (const std::string& id : ids) patterns.push_back({id});
    return patterns;
}

TEST(Painting, ChanceIsTheSameForTheSameSeedAndAnotherForAnother) {
    const auto palette = named({"0-1+1-6", "0-6+1-6", "1-6+5-6"});
    Tessellation a = blank(100);
    Tessellation b = blank(100);
    paint_randomly(a, palette, 7);
    paint_randomly(b, palette, 7);
    EXPECT_EQ(colours(a), colours(b));
    paint_randomly(b, palette, 8);
    EXPECT_NE(colours(a), colours(b));
    EXPECT_EQ(a.patterns, palette);
}

TEST(Painting, ChanceIsTheSameOnEveryMachine) {
    // SplitMix64 with seed 1 begins 10451216379200822465, 13757245211066428519, 17911839290282890590 (Vigna's
    // reference implementation); modulo 3.
    const auto palette = named({"a", "b", "c"});
    Tessellation tessellation = blank(3);
    paint_randomly(tessellation, palette, 1);
    EXPECT_THAT(colours(tessellation),
                ElementsAre(10451216379200822465U % 3, 13757245211066428519U % 3, 17911839290282890590U % 3));
}

TEST(Painting, ChanceFavoursNoPattern) {
    const auto palette = named({"a", "b", "c"});
    Tessellation tessellation = blank(9000);
    paint_randomly(tessellation, palette, 1);
    const std::vector<int> list = colours(tessellation);
    for (int pattern = 0; pattern < 3; ++pattern) {
        // Expected 3000; the standard deviation is 45, and five of them are hardly ever exceeded.
        EXPECT_NEAR(static_cast<double>(std::count(list.begin(), list.end(), pattern)), 3000, 5 * 45);
    }
}

TEST(Painting, WithoutPatternsNothingCanBePainted) {
    Tessellation tessellation = blank(2);
    EXPECT_THAT(complaint_of([&] { paint_randomly(tessellation, {}, 1); }), HasSubstr("no pattern"));
}

TEST(Painting, ByChanceIsForATessellationsNumberOfTiles) {
    const std::vector<WeightedPattern> patterns = {{{"a"}, 1.0}};
    for (const std::size_t tiles : {kMostPaintedTiles + 1, std::numeric_limits<std::size_t>::max()})
        EXPECT_THAT(complaint_of([&] { (void)random_painting(tiles, patterns, 1); }),
                    HasSubstr("the number of tiles is " + std::to_string(tiles) +
                              ", where 0 to 10000000 are possible"));
}

TEST(Painting, OnePatternPaintsAll) {
    Tessellation tessellation = blank(4);
    paint_uniformly(tessellation, {"0-1+1-6"});
    EXPECT_THAT(colours(tessellation), Each(0));
    EXPECT_THAT(pattern::ids_of(tessellation.patterns), ElementsAre("0-1+1-6"));
}

TEST(Painting, APaletteHasValidPatternsOnceEach) {
    const auto palette = [](const std::vector<std::string>& ids) {
        return pattern::ids_of(make_palette(paper_layout(), ids));
    };
    EXPECT_THAT(palette({"1-6+0-1", "0-5+5-6"}), ElementsAre("0-1+1-6", "0-5+5-6"));
    EXPECT_THAT(complaint_of([&] {
                    palette({"0-1+1-6", "0-1"});
                }),
                AllOf(HasSubstr("'0-1'"), HasSubstr("no beam ends at interface node n6")));
    EXPECT_THAT(complaint_of([&] {
                    palette({"0-1+1-6", "1-6+0-1"});
                }),
                HasSubstr("the pattern 0-1+1-6 is named twice"));
}

TEST(PaintingFile, ReadsBackWhatWasWritten) {
    const TemporaryFolder folder;
    const auto layout = paper_layout();
    for (const std::vector<int>& tiles : {std::vector<int>{}, std::vector<int>{1, 0, 1}}) {
        const Painting painting{
            pattern::parse_named_patterns(layout, std::vector<std::string>{"0-1+1-6", "0-5+5-6"}), tiles};
        write_painting(painting, layout, folder.path() / "p.json");
        const Painting read = read_painting(folder.path() / "p.json", layout);
        EXPECT_EQ(read.patterns, painting.patterns);
        EXPECT_EQ(read.tiles, painting.tiles);
    }
}

TEST(PaintingFile, APaintingIsForAsManyTiles) {
    Tessellation tessellation = blank(3);
    paint(tessellation, {{{"0-1+1-6"}, {"0-6+1-6"}}, {1, 0, 1}});
    EXPECT_THAT(colours(tessellation), ElementsAre(1, 0, 1));
    EXPECT_THAT(complaint_of([&] {
                    paint(tessellation, {{{"0-1+1-6"}}, {0, 0}});
                }),
                AllOf(HasSubstr("2 tiles"), HasSubstr("has 3")));
    EXPECT_THAT(complaint_of([&] {
                    paint(tessellation, {{{"0-1+1-6"}}, {0, 1, 0}});
                }),
                HasSubstr("no pattern 1"));
}

TEST(PaintTiles, RefusesAnIndexWithoutAPattern) {
    Tessellation tessellation = blank(2);
    paint_uniformly(tessellation, {"0-1+1-6"});
    for (const int index : {-1, 1})
        EXPECT_THAT(complaint_of([&] {
                        paint_tiles(tessellation, std::vector{TileIndex(0)}, {{{"0-6+1-6"}}, {index}});
                    }),
                    HasSubstr("no pattern " + std::to_string(index)));
    EXPECT_THAT(colours(tessellation), Each(0));
}

TEST(PaintingFile, ComplaintsNameFileAndPlace) {
    const TemporaryFolder folder;
    const auto refuse = [&](const std::string& members) {
        const auto path = folder.file("p.json", R"({"format":"fretwork/painting/1",)" + members + "}");
        std::string message = complaint_of([&] { read_painting(path, paper_layout()); });
        EXPECT_THAT(message, HasSubstr("p.json"));
        return message;
    };
    EXPECT_THAT(refuse(R"("layout":"other","patterns":["0-1+1-6"])"), HasSubstr("/layout"));
    EXPECT_THAT(refuse(R"("layout":"paper7","patterns":[])"), HasSubstr("/patterns"));
    EXPECT_THAT(refuse(R"("layout":"paper7","patterns":["0-1+1-6","9-9"])"), HasSubstr("/patterns/1"));
    EXPECT_THAT(refuse(R"("layout":"paper7","patterns":["0-1+1-6"],"tiles":[0,1])"), HasSubstr("/tiles/1"));
    EXPECT_THAT(refuse(R"("layout":"paper7","patterns":["0-1+1-6"],"tiles":[])"), HasSubstr("/tiles"));
    EXPECT_THAT(refuse(R"("layout":"paper7","patterns":["0-1+1-6"],"tile":[0])"),
                HasSubstr("unknown key 'tile'"));
    EXPECT_THAT(refuse(R"("layout":"paper7","patterns":["0-1+1-6","0-1"])"),
                AllOf(HasSubstr("/patterns/1"), HasSubstr("no_interface")));
    EXPECT_THAT(refuse(R"("layout":"paper7","patterns":["0-1+1-6","1-6+0-1"])"),
                AllOf(HasSubstr("/patterns/1"), HasSubstr("twice")));
    EXPECT_THAT(refuse(R"("layout":"paper7","patterns":[1])"), HasSubstr("/patterns/0"));
}

}  // namespace THIS_TEST
}  // namespace fretwork::tiling
