// SPDX-License-Identifier: GPL-3.0-or-later
#include "svg_reading.hpp"

#include <fretwork/exports/drawings/detail/furniture.hpp>
#include <fretwork/exports/drawings/pattern_drawing.hpp>
#include <fretwork/mechanics/linear_solver.hpp>
#include <fretwork/reduction/response.hpp>

#include <gmock/gmock.h>

namespace fretwork::exports {
namespace THIS_TEST {

using testing::HasSubstr;
using testing::Not;

const pattern::NodeLayout& layout() {
    static const auto paper7 = pattern::find_node_layout("paper7");
    return paper7;
}

ReducedPattern sample() {
    reduction::Calibration calibration;
    calibration.model = "paper6";
    calibration.parameters = {{"A", 4e-6},  {"I2", 1e-12}, {"I3", 1e-12},
                              {"J", 1e-12}, {"R", 0.01},   {"theta", 0.1}};
    return {pattern::parse_pattern_id(layout(), "0-1+1-6"), calibration};
}

TEST(ScenarioSheet, HasEachScenarioWithItsLargestMagnitude) {
    const reduction::Setting setting = reduction::paper_setting();
    const test::Svg svg(scenario_sheet_svg(layout(), sample(), setting));
    for (const reduction::Scenario& scenario : setting.scenarios)
        EXPECT_THAT(svg.words(), HasSubstr(scenario.name + " under " +
                                           detail::short_number(scenario.max_magnitude) + " N\n"));
}

/// So small a load bends the pattern as linear beams are bent.
TEST(ScenarioSheet, SaysHowFarThePatternMoves) {
    reduction::Setting setting = reduction::paper_setting();
    for (reduction::Scenario& scenario : setting.scenarios) scenario.max_magnitude *= 1e-4;
    const test::Svg svg(scenario_sheet_svg(layout(), sample(), setting));
    const auto tile = pattern_frame(layout(), sample().pattern, setting);
    for (const reduction::Scenario& scenario : setting.scenarios) {
        const auto solution = mechanics::solve_linear(mechanics::assemble(scenario_frame(tile, scenario)));
        const double largest = solution.displacements.leftCols<3>().rowwise().norm().maxCoeff();
        EXPECT_THAT(svg.words(), HasSubstr("moves by " + detail::millimetres(largest) + "\nreduced: "));
    }
}

TEST(ScenarioSheet, DrawsAPatternWithoutACalibrationAlone) {
    const ReducedPattern alone{sample().pattern};
    const test::Svg svg(scenario_sheet_svg(layout(), alone, reduction::paper_setting()));
    EXPECT_THAT(svg.words(), Not(HasSubstr("reduced")));
}

TEST(ScenarioSheet, IsLegibleInAColumnAndHasAKey) {
    const test::Svg svg(scenario_sheet_svg(layout(), sample(), reduction::paper_setting()));
    EXPECT_EQ(svg.root().attribute("data-print-width").as_double(), 84.0);
    EXPECT_GE(svg.smallest_text_in_print(), test::kLegible);
    EXPECT_THAT(svg.words(), HasSubstr("full model\nreduced model\nheld\nheld in part\nforce\nmoment\n"));
}

}  // namespace THIS_TEST
}  // namespace fretwork::exports
