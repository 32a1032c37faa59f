// SPDX-License-Identifier: GPL-3.0-or-later
#include "support.hpp"

#include <fretwork/base/files/file.hpp>
#include <fretwork/simulation/project/new_project.hpp>
#include <fretwork/simulation/project/painting_recipe.hpp>
#include <fretwork/simulation/project/project_file.hpp>
#include <fretwork/simulation/project/retiling.hpp>
#include <fretwork/tiling/painting/tile_choice.hpp>

#include <gmock/gmock.h>

#include <png.h>
#include <regex>

namespace fretwork::simulation {
namespace THIS_TEST {

using test::complaint_of;
using test::TemporaryFolder;
using testing::AllOf;
using testing::HasSubstr;
using testing::SizeIs;
using tiling::TileIndex;

const PaletteChoice kPalette{.ids = {"0-1+1-6", "2-4+4-6", "0-5+5-6"}};
const PaintByField kAlongX{.field = FieldExpression{"u"}, .palette = kPalette};

/// A plate of 0.3 x 0.2 m.
Project plate(const PaintingChoice& painting) {
    const outlines::Outline outline = outlines::make_outline({{0, 0}, {0.3, 0}, {0.3, 0.2}, {0, 0.2}}, {});
    return make_project(outline, {.edge_length = 0.03, .painting = painting}, nullptr).project;
}

std::vector<std::string> ids(const Project& project) {
    std::vector<std::string> list;
    for (const TileIndex tile : project.tessellation.tiles.indices()) {
        const auto* pattern = tiling::pattern_of(project.tessellation, tile);
        list.push_back(pattern != nullptr ? pattern->id : "");
    }
    return list;
}

Project on_other_tiles(const Project& project) {
    return retile(project, {.edge_length = 0.02}, nullptr).project;
}

/// The same tiles, painted by the choice and nothing else.
std::vector<std::string> painted_from_nothing(Project project, const PaintingChoice& choice) {
    project.recipes.clear();
    (void)paint(project, PaintOnePattern{"0-6"}, nullptr);
    (void)paint(project, choice, nullptr);
    return ids(project);
}

/// A PNG of one row of pixels, from white on the left to black on the right.
std::filesystem::path grey_ramp(const TemporaryFolder& folder) {
    std::vector<std::uint8_t> grey(256);
    for (std::size_t i = 0; i < grey.size(); ++i) grey[i] = static_cast<std::uint8_t>(255 - i);
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    image.width = 256;
    image.height = 1;
    image.format = PNG_FORMAT_GRAY;
    std::filesystem::path path = folder.path() / "ramp.png";
    EXPECT_NE(png_image_write_to_file(&image, path.c_str(), 0, grey.data(), 0, nullptr), 0) << image.message;
    return path;
}

constexpr const char* kDrawing =
    R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 300 200" width="300mm" height="200mm">
<rect width="150" height="200" fill="red"/><rect x="150" width="150" height="200" fill="#00f"/></svg>)";

TEST(PaintingRecipe, AFieldOnOtherTilesIsAsIfItWerePaintedThere) {
    const Project before = plate(kAlongX);
    ASSERT_THAT(before.recipes, SizeIs(1));
    EXPECT_EQ(before.recipes[0].choice, PaintingChoice(kAlongX));
    EXPECT_EQ(before.recipes[0].tiles.size(), before.tessellation.tiles.size());
    const Project after = on_other_tiles(before);
    EXPECT_GT(after.tessellation.tiles.size(), before.tessellation.tiles.size());
    EXPECT_EQ(ids(after), painted_from_nothing(after, kAlongX));
    EXPECT_EQ(after.recipes[0].tiles.size(), after.tessellation.tiles.size());
}

TEST(PaintingRecipe, IsTheSameAfterWritingAndReadingWithoutItsFiles) {
    std::vector<PaintingChoice> choices;
    Project before;
    {
        const TemporaryFolder folder;
        const std::filesystem::path drawing = folder.file("regions.svg", kDrawing);
        choices = {kAlongX,
                   PaintByField{.field = FieldImage{grey_ramp(folder)},
                                .palette = kPalette,
                                .property = "bending_stiffness",
                                .range = std::pair(0.02, 0.1),
                                .dithering = tiling::Dithering::ErrorDiffusion},
                   PaintByColours{drawing, {{"#ff0000", "0-1+1-6"}, {"#0000ff", "0-5+5-6"}}},
                   PaintAtRandom{.seed = ~std::uint64_t{0}, .palette = kPalette, .weights = {1, 2, 3}}};
        before = plate(PaintOnePattern{"0-6"});
        // A quarter of the tiles for each.
        for (std::size_t c = 0; c < choices.size(); ++c) {
            std::vector<TileIndex> tiles;
            for (std::size_t t = c; t < before.tessellation.tiles.size(); t += choices.size())
                tiles.emplace_back(t);
            EXPECT_EQ(paint(before, tiles, choices[c], nullptr), tiles);
        }
    }
    const std::string text = project_text(before);
    EXPECT_THAT(text, AllOf(HasSubstr("fretwork/project/4"), HasSubstr("ramp.png")));
    const Project read = parse_project(text, "p.json");
    EXPECT_EQ(read.recipes, before.recipes);
    EXPECT_THAT(read.recipes, SizeIs(4));
    EXPECT_EQ(project_text(read), text);
    EXPECT_EQ(ids(on_other_tiles(read)), ids(on_other_tiles(before)));
}

TEST(PaintingRecipe, AnImageAndADrawingComeWithTheirContent) {
    Project by_image;
    Project by_colours;
    {
        const TemporaryFolder folder;
        by_image = plate(PaintByField{.field = FieldImage{grey_ramp(folder)}, .palette = kPalette});
        by_colours = plate(PaintByColours{folder.file("regions.svg", kDrawing),
                                          {{"#ff0000", "0-1+1-6"}, {"#0000ff", "0-5+5-6"}}});
    }
    const Project finer = on_other_tiles(by_image);
    EXPECT_EQ(ids(finer), painted_from_nothing(finer, by_image.recipes.at(0).choice));
    EXPECT_EQ(finer.recipes.at(0).choice, by_image.recipes.at(0).choice);
    const Project coloured = on_other_tiles(by_colours);
    const auto centers = tiling::tile_centers(coloured.tessellation);
    for (const TileIndex tile : centers.indices())
        EXPECT_EQ(tiling::pattern_of(coloured.tessellation, tile)->id,
                  centers[tile].x < 0.15 ? "0-1+1-6" : "0-5+5-6");
}

TEST(PaintingRecipe, AColourHasOnePattern) {
    const TemporaryFolder folder;
    const std::filesystem::path drawing = folder.file("regions.svg", kDrawing);
    const auto painted = [&](const std::string& second) {
        (void)plate(PaintByColours{drawing, {{"#ff0000", "0-1+1-6"}, {second, "0-5+5-6"}}});
    };
    EXPECT_NO_THROW(painted("#0000ff"));
    EXPECT_THAT(complaint_of([&] { painted("#ff0000"); }),
                HasSubstr("palette: '0-1+1-6' and '0-5+5-6' are for one colour, #ff0000"));
}

TEST(PaintingRecipe, TilesThatArePaintedOtherwiseLeaveIt) {
    Project project = plate(kAlongX);
    const std::size_t count = project.tessellation.tiles.size();
    (void)paint(project, std::vector{TileIndex(0), TileIndex(3)}, PaintOnePattern{"0-6"}, nullptr);
    ASSERT_THAT(project.recipes, SizeIs(1));
    EXPECT_THAT(project.recipes[0].tiles, SizeIs(count - 2));
    const PaintAtRandom random{.seed = 5, .palette = kPalette};
    (void)paint(project, std::vector{TileIndex(1), TileIndex(3)}, random, nullptr);
    ASSERT_THAT(project.recipes, SizeIs(2));
    EXPECT_THAT(project.recipes[0].tiles, SizeIs(count - 3));
    EXPECT_EQ(project.recipes[1].tiles, (std::vector{TileIndex(1), TileIndex(3)}));
    end_recipes(project, std::vector{TileIndex(1), TileIndex(3)});
    EXPECT_THAT(project.recipes, SizeIs(1)) << "one without tiles goes";
    (void)paint(project, PaintOnePattern{"0-6"}, nullptr);
    EXPECT_THAT(project.recipes, SizeIs(0));
    EXPECT_THAT(project_text(project), HasSubstr("fretwork/project/2"));
}

TEST(PaintingRecipe, HandPaintedTilesStayByPlaceBesideIt) {
    Project before = plate(kAlongX);
    std::vector<TileIndex> left;
    const auto old_centers = tiling::tile_centers(before.tessellation);
    for (const TileIndex tile : old_centers.indices())
        if (old_centers[tile].x < 0.15) left.push_back(tile);
    (void)paint(before, left, PaintOnePattern{"0-6"}, nullptr);
    const CarriedOver carried = carry_over(before, new_tiles(before, {.edge_length = 0.02}));
    const Project after = on_other_tiles(before);
    const auto field = painted_from_nothing(after, kAlongX);
    const auto list = ids(after);
    for (const TileIndex tile : carried.from.indices()) {
        const bool is_by_hand = std::ranges::find(left, carried.from[tile]) != left.end();
        EXPECT_EQ(list[tile], is_by_hand ? "0-6" : field[tile]) << tile.value;
    }
}

TEST(PaintingRecipe, PaintingAllNewTilesOrAnotherLayoutEndsIt) {
    const Project before = plate(kAlongX);
    const RetilingOptions one{.edge_length = 0.02, .painting = PaintOnePattern{"0-6"}};
    EXPECT_THAT(retile(before, one, nullptr).project.recipes, SizeIs(0));
    const RetilingOptions other{.edge_length = 0.02, .layout = pattern::find_node_layout("paper8")};
    EXPECT_THAT(retile(before, other, nullptr).project.recipes, SizeIs(0));
}

TEST(PaintingRecipe, EqualChoicesAreOne) {
    Project project = plate(PaintOnePattern{"0-6"});
    (void)paint(project, std::vector{TileIndex(4), TileIndex(2)}, kAlongX, nullptr);
    (void)paint(project, std::vector{TileIndex(3), TileIndex(2)}, kAlongX, nullptr);
    ASSERT_THAT(project.recipes, SizeIs(1));
    EXPECT_EQ(project.recipes[0].tiles, (std::vector{TileIndex(2), TileIndex(3), TileIndex(4)}));
}

TEST(PaintingRecipe, HasATileOnceThatIsNamedTwice) {
    for (const PaintingChoice& choice :
         {PaintingChoice(kAlongX), PaintingChoice(PaintAtRandom{.seed = 5, .palette = kPalette})}) {
        Project project = plate(PaintOnePattern{"0-6"});
        (void)paint(project, std::vector{TileIndex(3), TileIndex(1), TileIndex(3)}, choice, nullptr);
        ASSERT_THAT(project.recipes, SizeIs(1));
        EXPECT_EQ(project.recipes[0].tiles, (std::vector{TileIndex(1), TileIndex(3)}));
        EXPECT_EQ(parse_project(project_text(project), "p.json").recipes, project.recipes);
    }
}

TEST(PaintingRecipe, OfAPaletteFileHasItsIds) {
    const TemporaryFolder folder;
    const auto file = folder.file("palette.json", R"({"format": "fretwork/painting/1", "layout": "paper7",
        "patterns": ["0-1+1-6", "0-5+5-6"]})");
    const Project project = plate(PaintByField{.field = FieldExpression{"u"}, .palette = {.file = file}});
    const auto& kept = std::get<PaintByField>(project.recipes.at(0).choice);
    EXPECT_EQ(kept.palette, (PaletteChoice{.ids = {"0-1+1-6", "0-5+5-6"}}));
}

TEST(PaintingRecipe, ALargeDrawingIsNotKept) {
    const TemporaryFolder folder;
    const std::string large = kDrawing + std::string(kLargestKeptFile, '\n');
    const Project project = plate(
        PaintByColours{folder.file("large.svg", large), {{"#ff0000", "0-1+1-6"}, {"#0000ff", "0-5+5-6"}}});
    EXPECT_THAT(project.recipes, SizeIs(0));
    EXPECT_EQ(std::ranges::count(ids(project), std::string()), 0) << "it is painted";
}

/// The complaint about the text of a project by a field in which the first match of `what` is replaced.
std::string complaint_after(const std::string& what, const std::string& replacement) {
    const std::string text = project_text(plate(kAlongX));
    const std::string changed =
        std::regex_replace(text, std::regex(what), replacement, std::regex_constants::format_first_only);
    EXPECT_NE(changed, text) << what;
    const std::string complaint = complaint_of([&] { (void)parse_project(changed, "p.json"); });
    EXPECT_EQ(complaint.find('\n'), std::string::npos) << complaint;
    return complaint;
}

TEST(PaintingRecipe, IsRefusedWithItsPlaceWhereItIsWrong) {
    EXPECT_THAT(complaint_after("project/4", "project/3"), HasSubstr("no recipes; fretwork/project/4 has"));
    EXPECT_THAT(complaint_after("\"field\"", "\"fields\""),
                HasSubstr("p.json: /recipes/0: must paint by exactly"));
    EXPECT_THAT(complaint_after("\"field\":", "\"random\": \"1\", \"field\":"), HasSubstr("exactly one of"));
    EXPECT_THAT(complaint_after("\"field\": \"u\"", "\"random\": \"one\""), HasSubstr("/recipes/0/random"));
    EXPECT_THAT(
        complaint_after("\"field\": \"u\"", "\"image\": {\"name\": \"a\", \"content_base64\": \"?\"}"),
        HasSubstr("/recipes/0/image/content_base64"));
    EXPECT_THAT(complaint_after("\"field\": \"u\"", "\"field\": \"u\", \"range\": [0, 1]"),
                HasSubstr("/recipes/0/range"));
    EXPECT_THAT(complaint_after("\"field\": \"u\"", "\"field\": \"u+\""),
                HasSubstr("p.json: /recipes/0/field: 'u+': "));
    EXPECT_THAT(complaint_after("\"field\": \"u\"", "\"field\": \"u\", \"mood\": 1"), HasSubstr("'mood'"));
}

TEST(PaintingRecipe, ThatCannotBeAppliedIsNamed) {
    Project project = plate(kAlongX);
    std::get<PaintByField>(project.recipes[0].choice).field = FieldExpression{"u +"};
    EXPECT_THAT(complaint_of([&] { (void)on_other_tiles(project); }),
                AllOf(HasSubstr("recipe 0: "), HasSubstr("'u +'")));
}

}  // namespace THIS_TEST
}  // namespace fretwork::simulation
