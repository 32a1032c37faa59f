// SPDX-License-Identifier: GPL-3.0-or-later
// Every layout that the library brings along, from patterns to a compared surface.
#include "support.hpp"

#include <fretwork/pattern/sample.hpp>
#include <fretwork/reduction/models/condensed_tile.hpp>
#include <fretwork/simulation/project/new_project.hpp>
#include <fretwork/simulation/results/comparison.hpp>
#include <fretwork/simulation/simulate.hpp>

#include <gtest/gtest.h>

namespace fretwork::simulation {
namespace THIS_TEST {

class EveryLayout : public testing::TestWithParam<std::string> {};

std::vector<pattern::Pattern> some_patterns(const pattern::NodeLayout& layout) {
    return pattern::PatternSampler(layout, {.edges = pattern::default_edge_range(layout)}, 1).draw(2);
}

/// A sheet of some 30 tiles, painted with two patterns at random, each with its calibration of paper6.
Surface sheet(const pattern::NodeLayout& layout) {
    NewProjectOptions options;
    options.edge_length = 0.026;
    options.layout = layout.name();
    PaintAtRandom painting;
    for (const pattern::Pattern& pattern : some_patterns(layout))
        painting.palette.ids.push_back(pattern_id(layout, pattern));
    options.painting = painting;
    const auto outline = outlines::make_outline({{0, 0}, {0.3, 0}, {0.3, 0.18}, {0, 0.18}}, {});
    Surface surface = make_surface(make_project(outline, options, nullptr).project, nullptr);
    surface.setting.divisions = 1;
    surface.setting.magnitudes = 2;
    surface.calibrations.clear();
    for (const auto& [id, pattern] : surface.tessellation.patterns) {
        const auto responses = reduction::compute_responses(layout, pattern, surface.setting);
        surface.calibrations.push_back({reduction::calibrate(reduction::find_tile_model("paper6"),
                                                             {layout, pattern, surface.setting, responses},
                                                             {.starts = 1, .budget = 300})});
    }
    return surface;
}

LoadCase cantilever() {
    LoadCase load_case;
    load_case.name = "cantilever";
    load_case.supports.push_back({NodesAtSide{Side::Left}, mechanics::DofSet::all()});
    load_case.loads.push_back(
        {NodesAtSide{Side::Right}, {0.0, 0.0, -0.02}, Eigen::Vector3d::Zero(), LoadCase::Amount::Total});
    return load_case;
}

TEST_P(EveryLayout, IsCalibratedTiledSolvedAndCompared) {
    const auto layout = pattern::find_node_layout(GetParam());
    const Surface surface = sheet(layout);
    const LoadCase load_case = cantilever();
    const auto exact = simulate(surface, load_case, {.model = "full", .analysis = Analysis::Linear});
    const auto condensed = simulate(surface, load_case, {.model = "condensed"});
    // Condensation is exact; what is left is rounding, magnified by the condition of soft patterns.
    EXPECT_LT(compare(exact, condensed).relative_l2_error, 1e-6);
    const auto full = simulate(surface, load_case, {.model = "full"});
    ASSERT_TRUE(full.solution.converged());
    const auto turning = simulate(surface, load_case, {.model = "corotational"});
    ASSERT_TRUE(turning.solution.converged());
    EXPECT_LT(compare(full, turning).relative_l2_error, 0.05);
    const auto ring = simulate(surface, load_case, {.model = "paper6", .estimate_linear_range = true});
    EXPECT_TRUE(std::isfinite(compare(full, ring).relative_l2_error));
    const Comparison fit = compare(exact, ring);
    ASSERT_TRUE(ring.fit_error);
    EXPECT_NEAR(*ring.fit_error, fit.max_translation_error / fit.max_displacement, 1e-6);
    EXPECT_FALSE(
        simulate(surface, load_case, {.model = "condensed", .estimate_linear_range = true}).fit_error)
        << "nothing is fitted";
}

INSTANTIATE_TEST_SUITE_P(Layouts, EveryLayout, testing::ValuesIn(pattern::layout_names()),
                         [](const auto& layout) { return layout.param; });

}  // namespace THIS_TEST
}  // namespace fretwork::simulation
