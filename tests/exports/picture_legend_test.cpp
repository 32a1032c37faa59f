// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/exports/space/detail/lettering.hpp>
#include <fretwork/exports/space/detail/picture_legend.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace fretwork::exports::detail {
namespace THIS_TEST {

const BarScene::Field kField{"displacement", "Displacement", "mm", 1e3, {0.0, 0.25, 1.0}};
const std::string kNote = "joints: stiff";

TEST(PictureLegend, StandsBelowThePictureOnTransparentGround) {
    constexpr PixelSize kSize{400, 300};
    const int height = legend_height(kSize);
    ASSERT_GT(height, 0);
    const std::vector<std::uint8_t> picture(std::size_t{4} * 400 * static_cast<std::size_t>(300 - height),
                                            77);
    const auto whole = with_legend(picture, kSize, {kField, kNote});
    ASSERT_EQ(whole.size(), std::size_t{4} * 400 * 300);
    EXPECT_TRUE(std::equal(picture.begin(), picture.end(), whole.begin())) << "it covers the surface";
    std::size_t opaque = 0;
    for (std::size_t i = picture.size() + 3; i < whole.size(); i += 4) {
        opaque += whole[i] == 255 ? 1 : 0;
    }
    EXPECT_GT(opaque, 1000U);
    EXPECT_LT(opaque, (whole.size() - picture.size()) / 8) << "more than letters and colours";
}

/// Relative luminance, as WCAG 2.1 has it.
double luminance(std::uint8_t red, std::uint8_t green, std::uint8_t blue) {
    const auto linear = [](std::uint8_t byte) {
        const double share = byte / 255.0;
        return share <= 0.04045 ? share / 12.92 : std::pow((share + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * linear(red) + 0.7152 * linear(green) + 0.0722 * linear(blue);
}

TEST(PictureLegend, LettersAreReadOnWhiteAndOnBlack) {
    // WCAG 2.1 wants a contrast of 3 of large letters. The note is the last line, and has no colours.
    constexpr PixelSize kSize{1600, 1000};
    const std::size_t above = std::size_t{4} * 1600 * static_cast<std::size_t>(1000 - legend_height(kSize));
    const auto whole = with_legend(std::vector<std::uint8_t>(above, 0), kSize, {kField, kNote});
    const std::size_t note = std::size_t{4} * 1600 * 945;
    std::size_t full = 0;
    for (std::size_t i = note; i < whole.size(); i += 4) {
        if (whole[i + 3] < 255) continue;
        ++full;
        const double ink = luminance(whole[i], whole[i + 1], whole[i + 2]);
        EXPECT_GT(1.05 / (ink + 0.05), 3.0) << "on white";
        EXPECT_GT((ink + 0.05) / 0.05, 3.0) << "on black";
    }
    EXPECT_GT(full, 100U);
}

TEST(Lettering, IsAsWideAsItsLetters) {
    const Lettering lettering(20);
    const LetteredText one = lettering.set("0");
    const LetteredText three = lettering.set("000");
    EXPECT_EQ(three.width, 3 * one.width) << "figures are equally wide";
    EXPECT_EQ(three.height, one.height);
    EXPECT_LT(lettering.set("iii").width, lettering.set("mmm").width);
    EXPECT_TRUE(std::ranges::any_of(one.coverage, [](std::uint8_t cover) { return cover > 200; }));
    EXPECT_EQ(lettering.set("").width, 0);
}

/// A byte that is no UTF-8 is a letter of its own, and takes no letter that follows it with it.
TEST(Lettering, KeepsTheLettersAfterMalformedBytes) {
    const Lettering lettering(20);
    EXPECT_EQ(lettering.set("\xc3m").width, lettering.set("\xc3\x83m").width)
        << "U+00C3 in Latin-1 and UTF-8";
    EXPECT_EQ(lettering.set("\xf0mm").coverage, lettering.set("\xc3\xb0mm").coverage);
}

TEST(Lettering, KnowsWhatUnitsAreMadeOf) {
    const Lettering lettering(20);
    const auto missing = lettering.set("\xef\xbf\xbe").coverage;  // U+FFFE is no letter
    for (const char* letter : {"µ", "°", "²", "·", "%", "ü"})
        EXPECT_NE(lettering.set(letter).coverage, missing) << letter;
}

TEST(PictureLegend, LeavesMostOfTheHeightToTheSurface) {
    for (const PixelSize size : {PixelSize{300, 300}, PixelSize{3000, 300}, PixelSize{4000, 390},
                                 PixelSize{8000, 700}, PixelSize{1600, 1000}, PixelSize{8000, 8000}}) {
        EXPECT_GT(legend_height(size), 0);
        EXPECT_LT(3 * legend_height(size), size.height) << size.width << "x" << size.height;
    }
}

TEST(PictureLegend, IsLeftOutOfSmallPictures) {
    const std::vector<std::uint8_t> picture(std::size_t{4} * 200 * 100, 77);
    EXPECT_EQ(legend_height({200, 100}), 0);
    EXPECT_EQ(with_legend(picture, {200, 100}, {kField, kNote}), picture);
}

}  // namespace THIS_TEST
}  // namespace fretwork::exports::detail
