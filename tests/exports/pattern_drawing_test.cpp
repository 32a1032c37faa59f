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
    EXPECT_EQ(svg.count("polygon"), 1U + 3U) << "the layout's base triangle, and the fans";
    for (const char* id : {"0-1+1-6", "1-6+3-6", "0-1+0-6+1-6"}) EXPECT_THAT(svg.words(), HasSubstr(id));
}

TEST(PatternSheet, WithoutPatternsShowsTheNumberedNodesOfTheLayoutOnly) {
    const auto layout = pattern::find_node_layout("paper7");
    const Svg svg(pattern_sheet_svg(layout, {}));
    EXPECT_EQ(svg.count("polygon"), 1U);
    EXPECT_EQ(svg.count("circle"), layout.nodes().size());
    EXPECT_THAT(svg.words(), HasSubstr("0\n1\n2\n3\n4\n5\n6\n"));
}

}  // namespace THIS_TEST
}  // namespace fretwork::exports
