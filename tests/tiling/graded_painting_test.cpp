// SPDX-License-Identifier: GPL-3.0-or-later
// Painting by fields, and by the colours of a drawing.
#include "support.hpp"

#include <fretwork/base/text.hpp>
#include <fretwork/outlines/coloured_drawing.hpp>
#include <fretwork/tiling/painting/field.hpp>
#include <fretwork/tiling/painting/graded_painting.hpp>
#include <fretwork/tiling/painting/tile_choice.hpp>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <map>
#include <numeric>
#include <png.h>

namespace fretwork::tiling {
namespace THIS_TEST {

using test::complaint_of;
using test::TemporaryFolder;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

/// A row of unit squares: tile i from x = i to i + 1; neighbours share an interface node.
Tessellation row_of_squares(int count) {
    Tessellation row;
    row.layout = "paper7";
    for (int i = 0; i <= count; ++i) {
        row.vertices.push_back({static_cast<double>(i), 0.0});
        row.vertices.push_back({static_cast<double>(i), 1.0});
        row.interface_nodes.push_back({static_cast<double>(i), 0.5});
    }
    for (int i = 0; i < count; ++i) {
        Tile tile;
        for (const int vertex : {2 * i, 2 * i + 2, 2 * i + 3, 2 * i + 1}) tile.vertices.emplace_back(vertex);
        tile.interface_nodes = {InterfaceIndex(i), InterfaceIndex(i + 1)};
        row.tiles.push_back(tile);
    }
    return row;
}

std::vector<TileIndex> all(const Tessellation& tessellation) {
    std::vector<TileIndex> tiles;
    for (std::size_t t = 0; t < tessellation.tiles.size(); ++t) tiles.emplace_back(t);
    return tiles;
}

const std::vector<GradedPattern> kSoftAndStiff = {{{"soft"}, 1.0}, {{"stiff"}, 3.0}};

TEST(GradedPainting, TakesThePatternWhoseValueIsNearest) {
    const Tessellation row = row_of_squares(4);
    const std::vector<double> wanted = {0.0, 1.9, 2.1, 9.0};
    const Painting painting = graded_painting(row, all(row), kSoftAndStiff, wanted, Dithering::None);
    EXPECT_THAT(painting.tiles, ElementsAre(0, 0, 1, 1));
}

TEST(GradedPainting, DitheringKeepsTheMeanOfTheWantedValues) {
    constexpr int kTiles = 400;
    const Tessellation row = row_of_squares(kTiles);
    for (const double wanted : {1.0, 1.25, 1.7, 2.0, 2.9, 3.0}) {
        const Painting painting = graded_painting(
            row, all(row), kSoftAndStiff, std::vector<double>(kTiles, wanted), Dithering::ErrorDiffusion);
        const double stiff = std::accumulate(painting.tiles.begin(), painting.tiles.end(), 0.0);
        // The error that is handed on never exceeds half of the distance between two patterns, and the last
        // tile keeps it.
        EXPECT_NEAR(1.0 + 2.0 * stiff / kTiles, wanted, 1.0 / kTiles) << wanted;
    }
}

TEST(GradedPainting, DitheringHandsNothingOnBeyondTheReachOfThePatterns) {
    const Tessellation row = row_of_squares(8);
    const std::vector<double> wanted = {100, 100, 100, 100, 1, 1, 1, 1};
    const Painting painting =
        graded_painting(row, all(row), kSoftAndStiff, wanted, Dithering::ErrorDiffusion);
    EXPECT_THAT(painting.tiles, ElementsAre(1, 1, 1, 1, 0, 0, 0, 0));
}

TEST(Field, ExpressionsKnowPlacesInMetresAndInShares) {
    const geometry::Box box{10, 20, 12, 24};
    const std::vector<geometry::Point2> points = {{10, 20}, {11, 24}};
    EXPECT_THAT(expression_values("x + 100*y", box, points), ElementsAre(2010, 2411));
    EXPECT_THAT(expression_values("u + 100*v", box, points), ElementsAre(0, 100.5));
    EXPECT_THAT(expression_values("x > 10.5 ? 1 : 0", box, points), ElementsAre(0, 1));
}

TEST(Field, RefusesWhatHasNoFiniteValue) {
    const std::vector<geometry::Point2> points = {{0, 0}};
    const auto complaint = [&](const std::string& expression) {
        return complaint_of([&] { (void)expression_values(expression, {0, 0, 1, 1}, points); });
    };
    EXPECT_THAT(complaint("1/x"), HasSubstr("no finite value at x = 0"));
    EXPECT_THAT(complaint("sin("), HasSubstr("variables x, y"));
    EXPECT_THAT(complaint("z"), HasSubstr("z"));
    EXPECT_THAT(complaint(""), HasSubstr("is empty; there are the variables"));
}

TEST(Field, ImagesThatAreNoneAreRefused) {
    const TemporaryFolder folder;
    const auto file = folder.file("grey.png", "no image");
    EXPECT_THAT(complaint_of([&] { (void)image_values(file, {}, {}); }), HasSubstr("grey.png"));
}

/// A PNG of one row of pixels, from white on the left to black on the right.
std::filesystem::path grey_ramp(const TemporaryFolder& folder, unsigned pixels) {
    std::vector<std::uint8_t> grey;
    for (unsigned i = 0; i < pixels; ++i)
        grey.push_back(static_cast<std::uint8_t>(255 - 255 * i / (pixels - 1)));
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    image.width = pixels;
    image.height = 1;
    image.format = PNG_FORMAT_GRAY;
    std::filesystem::path path = folder.path() / "ramp.png";
    EXPECT_NE(png_image_write_to_file(&image, path.c_str(), 0, grey.data(), 0, nullptr), 0) << image.message;
    return path;
}

/// A PNG of one row of pixels in this format of libpng.
std::filesystem::path row_of_pixels(const TemporaryFolder& folder, png_uint_32 format,
                                    const std::vector<std::uint8_t>& components) {
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    image.format = format;
    image.height = 1;
    image.width = static_cast<png_uint_32>(components.size()) / PNG_IMAGE_SAMPLE_CHANNELS(format);
    std::filesystem::path path = folder.path() / "row.png";
    EXPECT_NE(png_image_write_to_file(&image, path.c_str(), 0, components.data(), 0, nullptr), 0)
        << image.message;
    return path;
}

/// The values of a row of pixels, from left to right.
std::vector<double> pixel_values(const std::filesystem::path& png, int pixels) {
    std::vector<geometry::Point2> points;
    for (int i = 0; i < pixels; ++i) points.push_back({i + 0.5, 0.5});
    return image_values(png, {0, 0, static_cast<double>(pixels), 1}, points);
}

/// A big-endian number of a PNG file.
std::string four_bytes(std::size_t value) {
    std::string bytes;
    for (const unsigned shift : {24U, 16U, 8U, 0U})
        bytes.push_back(static_cast<char>((value >> shift) & 255U));
    return bytes;
}

/// A chunk of a PNG file, with its CRC-32.
std::string chunk(const std::string& type, const std::string& data) {
    std::uint32_t sum = 0xffffffffU;
    for (const char c : type + data) {
        sum ^= static_cast<unsigned char>(c);
        for (int bit = 0; bit < 8; ++bit) sum = (sum >> 1U) ^ ((sum & 1U) * 0xedb88320U);
    }
    return four_bytes(data.size()) + type + data + four_bytes(~sum);
}

/// The data of a PNG file with stored blocks: the row, after the number of its filter.
std::string stored(const std::string& row) {
    const std::string data = std::string(1, '\0') + row;
    std::uint32_t a = 1;  // Adler-32
    std::uint32_t b = 0;
    for (const char c : data) {
        a = (a + static_cast<unsigned char>(c)) % 65521U;
        b = (b + a) % 65521U;
    }
    const auto length = static_cast<unsigned>(data.size());
    std::string bytes = "\x78\x01\x01";
    for (const unsigned half : {length, ~length}) {
        bytes.push_back(static_cast<char>(half & 255U));
        bytes.push_back(static_cast<char>((half >> 8U) & 255U));
    }
    return bytes + data + four_bytes((std::size_t{b} << 16U) | a);
}

/// A grey PNG of one row without any chunk about gamma, which libpng would write: with 8 or 16 bits.
std::string plain_grey(const std::vector<int>& greys, int bits) {
    std::string row;
    for (const int grey : greys)
        row += std::string(static_cast<std::size_t>(bits / 8), static_cast<char>(grey));
    const std::string header = four_bytes(greys.size()) + four_bytes(1) +
                               std::string{static_cast<char>(bits), '\0', '\0', '\0', '\0'};
    return "\x89PNG\r\n\x1a\n" + chunk("IHDR", header) + chunk("IDAT", stored(row)) + chunk("IEND", "");
}

TEST(Field, AnImageOfSixteenBitsHasTheValuesOfOneOfEight) {
    const TemporaryFolder folder;
    const std::vector<int> greys = {0, 64, 128, 255};
    for (const int bits : {8, 16}) {
        const auto values = pixel_values(folder.file("grey.png", plain_grey(greys, bits)), 4);
        for (std::size_t i = 0; i < greys.size(); ++i)
            EXPECT_NEAR(values.at(i), 1.0 - greys[i] / 255.0, 1.0 / 255) << bits << " bits, pixel " << i;
    }
}

TEST(Field, AShareOfOpacityIsThatShareOfDarkness) {
    const TemporaryFolder folder;
    const std::vector<std::uint8_t> greys = {0, 255, 0, 128, 0, 0, 255, 128, 100, 128};
    const auto values = pixel_values(row_of_pixels(folder, PNG_FORMAT_GA, greys), 5);
    EXPECT_THAT(values, ElementsAre(1.0, testing::DoubleNear(128 / 255.0, 1e-12), 0.0, 0.0,
                                    testing::DoubleNear(128 / 255.0 * 155 / 255.0, 1e-12)));
    const std::vector<std::uint8_t> colours = {0, 0, 0, 128, 100, 100, 100, 255, 9, 9, 9, 0};
    EXPECT_THAT(
        pixel_values(row_of_pixels(folder, PNG_FORMAT_RGBA, colours), 3),
        ElementsAre(testing::DoubleNear(128 / 255.0, 1e-12), testing::DoubleNear(155 / 255.0, 1e-12), 0.0));
}

TEST(Field, PlacesThatAreNoNumbersAreRefused) {
    const TemporaryFolder folder;
    const auto ramp = grey_ramp(folder, 8);
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    for (const double bad : {kNone, std::numeric_limits<double>::infinity(), -1e300}) {
        EXPECT_THAT(complaint_of([&] {
                        (void)image_values(ramp, {0, 0, 1, 1}, {{0.5, 0.5}, {0.5, bad}});
                    }),
                    AllOf(HasSubstr("point 1 is (0.5, " + base::format_number(bad) + ")"),
                          HasSubstr("a number from -1e+12 to 1e+12 (m)")));
        EXPECT_THAT(complaint_of([&] {
                        (void)image_values(ramp, {bad, 0, 1, 1}, {{0.5, 0.5}});
                    }),
                    HasSubstr("the lower left corner of the box is (" + base::format_number(bad) + ", 0)"));
    }
}

/// The last chunk, IEND, is the last 12 bytes; libpng has all pixels without it.
TEST(Field, AnImageWithoutItsEndIsRefused) {
    const TemporaryFolder folder;
    const std::string whole = base::read_text_file(grey_ramp(folder, 256));
    for (const std::size_t lost : {1, 4, 12, 13}) {
        const auto file = folder.file("cut.png", whole.substr(0, whole.size() - lost));
        EXPECT_THAT(complaint_of([&] { (void)image_values(file, {}, {}); }),
                    HasSubstr("cut.png: cannot be read as a PNG image"))
            << lost;
    }
    EXPECT_NO_THROW((void)image_values(folder.file("more.png", whole + "behind it"), {}, {}));
}

std::vector<geometry::Point2> middles(const Tessellation& row) {
    return tile_centers(row);
}

TEST(Field, AGreyRampIsReadFromWhiteToBlackAcrossTheBox) {
    const TemporaryFolder folder;
    const auto ramp = grey_ramp(folder, 256);
    const Tessellation row = row_of_squares(40);
    const auto values = image_values(ramp, {0, 0, 40, 1}, middles(row));
    ASSERT_EQ(values.size(), 40U);
    // A pixel is 1/256 of the width, a grey 1/255 of the way to black.
    for (std::size_t i = 0; i < values.size(); ++i)
        EXPECT_NEAR(values[i], (static_cast<double>(i) + 0.5) / 40, 2.0 / 255) << i;
    EXPECT_EQ(image_values(base::read_text_file(ramp), "ramp", {0, 0, 40, 1}, middles(row)), values);
    EXPECT_THAT(complaint_of([] { (void)image_values("no image", "my.png", {}, {}); }),
                HasSubstr("my.png: cannot be read as a PNG image"));
}

const std::vector<GradedPattern> kFromLightToDark = {{{"a"}, 0.0}, {{"b"}, 0.4}, {{"c"}, 0.6}, {{"d"}, 1.0}};

TEST(GradedPainting, AGreyRampGivesThePatternsInTheirOrder) {
    const TemporaryFolder folder;
    const Tessellation row = row_of_squares(40);
    const auto values = image_values(grey_ramp(folder, 256), {0, 0, 40, 1}, middles(row));
    const Painting painting = graded_painting(row, all(row), kFromLightToDark, values, Dithering::None);
    EXPECT_TRUE(std::ranges::is_sorted(painting.tiles));
    // Nearer to 0 than to 0.4: 0 to 0.2, eight tiles; and so on: bounds at 0.2, 0.5, 0.8.
    for (const auto& [pattern, count] : std::map<int, int>{{0, 8}, {1, 12}, {2, 12}, {3, 8}})
        EXPECT_EQ(std::ranges::count(painting.tiles, pattern), count) << pattern;
}

TEST(GradedPainting, ADitheredGreyRampHasTheMeanOfTheImageInEveryPart) {
    const TemporaryFolder folder;
    constexpr int kTiles = 400;
    constexpr int kPart = 40;
    const Tessellation row = row_of_squares(kTiles);
    const auto values = image_values(grey_ramp(folder, 256), {0, 0, kTiles, 1}, middles(row));
    const std::vector<GradedPattern> two = {{{"light"}, 0.0}, {{"dark"}, 1.0}};
    const Painting painting = graded_painting(row, all(row), two, values, Dithering::ErrorDiffusion);
    for (int from = 0; from < kTiles; from += kPart) {
        const double dark =
            std::accumulate(painting.tiles.begin() + from, painting.tiles.begin() + from + kPart, 0.0);
        const double wanted = std::accumulate(values.begin() + from, values.begin() + from + kPart, 0.0);
        // In a row, at most half of a tile is handed on at either end of a part.
        EXPECT_NEAR(dark, wanted, 1.0) << from;
    }
}

TEST(TileChoice, NumbersAndRangesAreTilesOnce) {
    const Tessellation row = row_of_squares(6);
    EXPECT_THAT(parse_tiles("4,0-2,1", row), ElementsAre(0, 1, 2, 4));
    for (const char* bad : {"6", "", "2-1", "-1", "1-2-3", "a"})
        EXPECT_NE(complaint_of([&] { (void)parse_tiles(bad, row); }), "") << bad;
}

TEST(TileChoice, ATileLiesWhereItsMiddleDoes) {
    const Tessellation row = row_of_squares(4);
    EXPECT_THAT(tiles_in(geometry::Box{0.6, 0, 2.5, 1}, row), ElementsAre(1, 2));
    EXPECT_THAT(tiles_in(geometry::Circle{{1, 0.5}, 0.6}, row), ElementsAre(0, 1));
    EXPECT_TRUE(tiles_in(geometry::Circle{{1, 0.5}, 0.4}, row).empty());
    EXPECT_THAT(tiles_in(geometry::Polygon{{0, 0}, {2, 0}, {2, 1}, {0, 1}}, row), ElementsAre(0, 1));
    EXPECT_THAT(tiles_in(geometry::Polygon{{0, 1}, {2, 1}, {2, 0}, {0, 0}}, row), ElementsAre(0, 1))
        << "clockwise means the same";
}

TEST(Painting, SomeTilesArePaintedAndTheOthersKeepTheirs) {
    Tessellation row = row_of_squares(4);
    paint_uniformly(row, {"a"});
    paint_tiles(row, std::vector{TileIndex(1), TileIndex(2)}, {{{"b"}, {"c"}}, {1, 0}});
    EXPECT_THAT(pattern::ids_of(row.patterns), ElementsAre("a", "b", "c"));
    paint_tiles(row, std::vector{TileIndex(0), TileIndex(3)}, {{{"b"}}, {0, 0}});
    EXPECT_THAT(pattern::ids_of(row.patterns), ElementsAre("b", "c")) << "no tile has a any more";
    EXPECT_EQ(row.tiles[1].pattern, 1);
    EXPECT_EQ(row.tiles[3].pattern, 0);
}

TEST(Painting, WeightsAreChances) {
    const Painting painting =
        random_painting(20'000, std::vector<WeightedPattern>{{{"a"}, 3.0}, {{"b"}, 1.0}}, 5);
    const double share = std::accumulate(painting.tiles.begin(), painting.tiles.end(), 0.0) / 20'000;
    // Five standard deviations of a share of 1/4 among 20,000.
    EXPECT_NEAR(share, 0.25, 5 * 0.0031);
}

constexpr const char* kDrawing =
    R"svg(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 300 100" width="300mm" height="100mm">
<style>.blue { fill: rgb(0, 0, 255) }</style>
<clipPath id="low"><rect y="50" width="300" height="50"/></clipPath>
<rect width="300" height="100" fill="red"/>
<g color="lime"><rect x="100" width="100" height="100" fill="currentColor" clip-path="url(#low)"/></g>
<path class="blue" d="M200 0h100v100h-100z M220 20h60v60h-60z" fill-rule="evenodd"/></svg>)svg";

TEST(ColouredDrawing, ShowsTheColourThatIsPaintedLast) {
    const TemporaryFolder folder;
    const outlines::ColouredDrawing drawing(folder.file("regions.svg", kDrawing));
    EXPECT_THAT(drawing.colours(), ElementsAre("#ff0000", "#00ff00", "#0000ff"));
    EXPECT_EQ(drawing.colour_at({0.05, 0.05}), "#ff0000");
    EXPECT_EQ(drawing.colour_at({0.15, 0.02}), "#00ff00") << "y runs upwards";
    EXPECT_EQ(drawing.colour_at({0.15, 0.08}), "#ff0000") << "clipped away";
    EXPECT_EQ(drawing.colour_at({0.21, 0.05}), "#0000ff");
    EXPECT_EQ(drawing.colour_at({0.25, 0.05}), "#ff0000") << "seen through the hole";
    EXPECT_EQ(drawing.colour_at({0.5, 0.05}), std::nullopt);
}

TEST(ColouredDrawing, IsTheSameFromItsText) {
    const outlines::ColouredDrawing drawing = outlines::ColouredDrawing::parse(kDrawing, "regions.svg");
    const TemporaryFolder folder;
    EXPECT_EQ(drawing.colours(), outlines::ColouredDrawing(folder.file("regions.svg", kDrawing)).colours());
    EXPECT_THAT(complaint_of([] { (void)outlines::ColouredDrawing::parse("<svg", "my.svg"); }),
                HasSubstr("my.svg"));
    std::string deep = "<svg><style>x g g g g g g g g g g g g g g rect { fill: none }</style>";
    for (int i = 0; i < 200; ++i) deep += "<g>";
    deep += "<rect width='9' height='9'/>";
    for (int i = 0; i < 200; ++i) deep += "</g>";
    EXPECT_THAT(complaint_of([&] { (void)outlines::ColouredDrawing::parse(deep + "</svg>", "my.svg"); }),
                HasSubstr("my.svg: its style sheets"));
}

TEST(ColouredDrawing, ColoursAreThoseOfCss) {
    for (const char* red : {"red", "RED", "#f00", "#ff0000", "rgb(255, 0, 0)", "rgb(100% 0% 0% / 50%)",
                            "rgb(255 0 0 / none)", "rgb(255 0 0 / calc(0.5))", "#f00f"})
        EXPECT_EQ(outlines::parse_colour(red), "#ff0000") << red;
    EXPECT_EQ(outlines::parse_colour("rebeccapurple"), "#663399");
    for (const char* none : {"reddish", "rgb(nan, 0, 0)", "rgb(1, 2, 3, x)"})
        EXPECT_NE(complaint_of([&] { (void)outlines::parse_colour(none); }), "") << none;
}

}  // namespace THIS_TEST
}  // namespace fretwork::tiling
