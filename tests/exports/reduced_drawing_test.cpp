// SPDX-License-Identifier: GPL-3.0-or-later
#include "svg_reading.hpp"

#include <fretwork/exports/drawings/pattern_drawing.hpp>

#include <gmock/gmock.h>

namespace fretwork::exports {
namespace THIS_TEST {

using testing::HasSubstr;

TEST(ReducedSheet, HasEachPatternAndItsReducedModelWithItsFacts) {
    const auto layout = pattern::find_node_layout("paper7");
    reduction::Calibration calibration;
    calibration.model = "paper6";
    calibration.parameters = {{"A", 4e-6},  {"I2", 1e-12}, {"I3", 1e-12},
                              {"J", 1e-12}, {"R", 0.01},   {"theta", 0.1}};
    calibration.objective = 3.25;
    const std::vector<ReducedPattern> patterns = {{pattern::parse_pattern_id(layout, "0-1+1-6"), calibration},
                                                  {pattern::parse_pattern_id(layout, "1-6+3-6")}};
    const test::Svg svg(reduced_sheet_svg(layout, patterns, reduction::paper_setting()));
    EXPECT_EQ(svg.count("polygon"), 3U) << "two patterns and one reduced model";
    EXPECT_EQ(svg.count("circle"), 6U) << "the reduced model's interface nodes";
    EXPECT_THAT(svg.words(), HasSubstr("0-1+1-6\n"));
    EXPECT_THAT(svg.words(), HasSubstr("theta = 5.73\xc2\xb0\nE = 3.25\n"));
    EXPECT_THAT(svg.words(), HasSubstr("not calibrated\n"));
}

TEST(ReducedSheet, IsLegibleInAColumnWithFewPatternsAndOnAPageWithMany) {
    const auto layout = pattern::find_node_layout("paper7");
    const ReducedPattern entry{pattern::parse_pattern_id(layout, "0-1+1-2+1-3+1-4+1-5+2-5+2-6+4-5+4-6+5-6")};
    for (const auto& [count, print] : {std::pair{1, 84.0}, {6, 84.0}, {12, 177.0}}) {
        const std::vector<ReducedPattern> patterns(static_cast<std::size_t>(count), entry);
        const test::Svg svg(reduced_sheet_svg(layout, patterns, reduction::paper_setting()));
        EXPECT_EQ(svg.root().attribute("data-print-width").as_double(), print) << count;
        EXPECT_GE(svg.smallest_text_in_print(), test::kLegible) << count;
    }
}

}  // namespace THIS_TEST
}  // namespace fretwork::exports
