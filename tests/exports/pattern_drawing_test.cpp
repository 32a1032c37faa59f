// SPDX-License-Identifier: GPL-3.0-or-later
#include "sample.hpp"
#include "svg_reading.hpp"

#include <fretwork/exports/drawings/pattern_drawing.hpp>

namespace fretwork::exports {
namespace THIS_TEST {

using namespace test;
using testing::HasSubstr;

TEST(PatternSheet, IsAtTrueScale) {
    const auto layout = pattern::find_node_layout("paper7");
    const std::vector<pattern::Pattern> patterns = {pattern::parse_pattern_id(layout, "0-1+1-6")};
    PatternDrawingOptions options;
    const double width = Svg(pattern_sheet_svg(layout, patterns, options)).width_mm();
    options.tile_side *= 2.0;
    EXPECT_NEAR(Svg(pattern_sheet_svg(layout, patterns, options)).width_mm(), 2.0 * width, 0.01);
}

TEST(PatternSheet, HasAFanWithItsIdForEveryPattern) {
    const auto layout = pattern::find_node_layout("paper7");
    std::vector<pattern::Pattern> patterns;
    for (const char* id : {"0-1+1-6", "1-6+3-6", "0-1+0-6+1-6"})
        patterns.push_back(pattern::parse_pattern_id(layout, id));
    const Svg svg(pattern_sheet_svg(layout, patterns));
    EXPECT_EQ(svg.count("polygon"), 1U + 3U + 2U)
        << "the layout's base triangle, the fans, and a swatch for each number of edges";
    EXPECT_THAT(svg.words(), HasSubstr("edges:\n2\n3\n"));
    for (const char* id : {"0-1+1-6", "1-6+3-6", "0-1+0-6+1-6"}) EXPECT_THAT(svg.words(), HasSubstr(id));
}

TEST(PatternSheet, WithoutPatternsShowsTheNumberedNodesOfTheLayoutOnly) {
    const auto layout = pattern::find_node_layout("paper7");
    const Svg svg(pattern_sheet_svg(layout, {}));
    EXPECT_EQ(svg.count("polygon"), 1U);
    EXPECT_EQ(svg.count("circle"), layout.nodes().size());
    EXPECT_THAT(svg.words(), HasSubstr("0\n1\n2\n3\n4\n5\n6\n"));
}

std::vector<pattern::Pattern> patterns_with(const pattern::NodeLayout& layout, int count) {
    std::vector<pattern::Pattern> patterns;
    for (int i = 0; i < count; ++i)
        patterns.push_back(pattern::parse_pattern_id(
            layout, i % 2 == 0 ? "0-1+1-6" : "0-1+1-2+1-3+1-4+1-5+2-5+2-6+4-5+4-6+5-6"));
    return patterns;
}

TEST(PatternSheet, IsLegibleInAColumnWithFewPatternsAndOnAPageWithMany) {
    const auto layout = pattern::find_node_layout("paper7");
    for (const auto& [count, print] :
         {std::pair{1, 84.0}, {16, 84.0}, {17, 177.0}, {60, 177.0}, {100, 177.0}}) {
        const Svg svg(pattern_sheet_svg(layout, patterns_with(layout, count)));
        EXPECT_EQ(svg.root().attribute("data-print-width").as_double(), print) << count;
        EXPECT_GE(svg.smallest_text_in_print(), kLegible) << count;
    }
}

TEST(PatternSheet, OfMorePatternsThanAPageHoldsDoesNotSayHowItIsPrinted) {
    const auto layout = pattern::find_node_layout("paper7");
    const Svg svg(pattern_sheet_svg(layout, patterns_with(layout, 400)));
    EXPECT_FALSE(svg.root().attribute("data-print-width"));
}

TEST(PatternSheet, LongIdsAreBrokenBetweenEdges) {
    const auto layout = pattern::find_node_layout("paper7");
    const Svg svg(pattern_sheet_svg(layout, patterns_with(layout, 60)));
    EXPECT_THAT(svg.words(), HasSubstr("0-1+1-2+1-3\n+1-4+1-5+2-5\n+2-6+4-5+4-6\n+5-6\n"));
}

TEST(RejectionSheet, IsLegibleAndNamesFiltersInWords) {
    const auto layout = pattern::find_node_layout("paper7");
    const auto rejections = pattern::find_rejections(layout, {.edges = {2, 3}}, 8);
    ASSERT_GE(rejections.size(), 8U);
    const Svg svg(rejection_sheet_svg(layout, rejections));
    EXPECT_GE(svg.smallest_text_in_print(), kLegible);
    EXPECT_THAT(svg.words(), HasSubstr("multiple components\n"));
    EXPECT_THAT(svg.words(), HasSubstr("no interface\n"));
}

}  // namespace THIS_TEST
}  // namespace fretwork::exports
