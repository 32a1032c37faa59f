// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/exports/colours.hpp>

#include <gtest/gtest.h>

#include <regex>
#include <set>
#include <vector>

namespace fretwork::exports {
namespace THIS_TEST {

int channel(const std::string& colour, std::size_t i) {
    return colour_bytes(colour)[i];
}

TEST(ColourBytes, AreThoseOfTheText) {
    EXPECT_EQ(colour_bytes("#00ff10"), (std::array<std::uint8_t, 3>{0, 255, 16}));
    EXPECT_EQ(colour_bytes(kBeyondColour), (std::array<std::uint8_t, 3>{0xf0, 0x18, 0xb4}));
}

/// Relative luminance (Rec. 709, without its gamma): enough to order greys.
double brightness(const std::string& colour) {
    return 0.2126 * channel(colour, 0) + 0.7152 * channel(colour, 1) + 0.0722 * channel(colour, 2);
}

TEST(PatternColour, IsDifferentForEachPatternOfAPalette) {
    std::set<std::string> seen;
    for (int i = -1; i < 60; ++i) {
        const std::string colour = pattern_colour(i);
        EXPECT_TRUE(std::regex_match(colour, std::regex("#[0-9a-f]{6}"))) << colour;
        EXPECT_TRUE(seen.insert(colour).second) << i << " has a colour that was there already: " << colour;
    }
}

TEST(PatternColour, IsLightEnoughForDarkBeams) {
    const double beam = brightness("#22303c");
    for (int i = -1; i < 200; ++i) EXPECT_GT(brightness(pattern_colour(i)), beam + 80.0) << i;
}

TEST(ScaleColour, GetsBrighterMonotonicallyAndIsClamped) {
    for (int i = 0; i < 100; ++i)
        EXPECT_LT(brightness(scale_colour(i / 100.0)), brightness(scale_colour((i + 1) / 100.0)) + 0.5) << i;
    EXPECT_EQ(scale_colour(-1.0), scale_colour(0.0));
    EXPECT_EQ(scale_colour(2.0), scale_colour(1.0));
}

TEST(ValueColour, OfValuesBeyondTheRangeIsInNeitherScale) {
    std::vector<double> values(1000, 1.0);
    values[7] = 50.0;
    const ValueRange range = value_range(values);
    EXPECT_EQ(value_colour(50.0, range), kBeyondColour);
    EXPECT_EQ(value_colour(1.0, range), scale_colour(1.0));
    EXPECT_EQ(largest_beyond(values, range), 50.0);
    values[8] = -60.0;
    const ValueRange both = value_range(values);
    EXPECT_EQ(value_colour(-60.0, both), kBeyondColour);
    EXPECT_EQ(value_colour(-1.0, both), signed_colour(0.0));
    EXPECT_EQ(largest_beyond(values, both), 60.0);
    EXPECT_EQ(largest_beyond(std::vector<double>{1.0, 2.0}, {0.0, 2.0}), std::nullopt);
}

}  // namespace THIS_TEST
}  // namespace fretwork::exports
