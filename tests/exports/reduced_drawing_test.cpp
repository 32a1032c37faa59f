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
    EXPECT_THAT(svg.words(), HasSubstr("theta = 5.73\xc2\xb0, E = 3.25\n"));
    EXPECT_THAT(svg.words(), HasSubstr("not calibrated\n"));
}

}  // namespace THIS_TEST
}  // namespace fretwork::exports
