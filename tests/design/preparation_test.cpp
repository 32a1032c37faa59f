// SPDX-License-Identifier: GPL-3.0-or-later
#include "hidden.hpp"
#include "trials_of.hpp"

#include <fretwork/design/search/preparation.hpp>
#include <fretwork/design/search/search.hpp>
#include <fretwork/pattern/enumerate.hpp>
#include <fretwork/pattern/mirror.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <utility>

namespace fretwork::design::detail {
namespace THIS_TEST {

struct Planted {
    simulation::Project project = test::cantilever_project(6, 4, 0.03);
    Target target;
    Planted() {
        simulation::Project hidden = project;
        test::paint_graded(hidden, test::kDesignPatterns);
        target = test::target_of(hidden);
    }
};

TEST(Preparation, CondensesTheWholePaletteLaterAndKeepsTheIndices) {
    const Planted planted;
    const DesignOptions options = test::design_options(planted.project);
    Preparation first = prepare(planted.project, nullptr, planted.target, options, 2);
    EXPECT_EQ(first.palette.size(), 2U);
    EXPECT_EQ(first.whole.size(), test::kDesignPatterns.size());
    const auto before = first.parts.candidates.patterns();
    Trials trials(std::move(first.parts));
    const Point point = trials.uniform(1);
    const Trial trial = trials.solve(point, {});
    const ExtendedPalette choice = extend_palette(trials, first.whole, options);
    const auto& candidates = trials.parts().candidates.patterns();
    ASSERT_GE(candidates.size(), before.size());
    for (std::size_t p = 0; p < before.size(); ++p) EXPECT_EQ(candidates[p].id, before[p].id);
    const std::set<std::size_t> palette(choice.palette.begin(), choice.palette.end());
    EXPECT_EQ(palette.size(), test::kDesignPatterns.size());
    EXPECT_EQ(choice.coordinates.cols(), std::ssize(choice.palette));
    EXPECT_TRUE(trials.is_at(point));
    const SwapTable table = trials.table(point, trial, {0, 1, 2, 3, 4}, 1, {});
    EXPECT_NEAR(table.unreached + table.residual.squaredNorm(), trial.objective, 1e-9 * trial.objective);
}

TEST(Preparation, CondensesAllAtOnceIfThereAreFew) {
    const Planted planted;
    const Preparation all =
        prepare(planted.project, nullptr, planted.target, test::design_options(planted.project), 5);
    EXPECT_TRUE(all.whole.empty());
    EXPECT_EQ(all.palette.size(), test::kDesignPatterns.size());
}

/// Tiles 0 and 4 are images of each other, and keep a pattern that has none.
TEST(Preparation, CondensesMoreBesideAKeptPatternWithoutAMirrorImage) {
    simulation::Project project = test::cantilever_project(5, 4, 0.03);
    simulation::Project hidden = project;
    test::paint_graded(hidden, test::kDesignPatterns);
    const auto patterns = pattern::parse_named_patterns(project.layout, test::kDesignPatterns);
    ASSERT_FALSE(pattern::Mirror(project.layout).image(patterns.back().pattern));
    project.tessellation.patterns.push_back(patterns.back());
    DesignOptions options = test::design_options(project);
    options.symmetry = {Symmetry::Kind::MirrorX};
    options.keep = {tiling::TileIndex(0), tiling::TileIndex(4)};
    for (const tiling::TileIndex tile : options.keep) project.tessellation.tiles[tile].pattern = 1;
    Preparation first = prepare(project, nullptr, test::target_of(hidden), options, 2);
    ASSERT_FALSE(first.whole.empty());
    Trials trials(std::move(first.parts));
    const ExtendedPalette choice = extend_palette(trials, first.whole, options);
    EXPECT_EQ(choice.palette.size(), first.whole.size());
    EXPECT_EQ(trials.parts().mirrored.size(), trials.parts().candidates.patterns().size());
}

TEST(Preparation, GivesCoordinatesToThePatternsOfAllUniformPaintings) {
    const Planted planted;
    DesignOptions options = test::design_options(planted.project);
    options.palette.clear();
    const pattern::NodeLayout& layout = planted.project.layout;
    for (const pattern::Pattern& own : pattern::enumerate_patterns(layout)) {
        if (options.palette.size() < 190) options.palette.push_back(pattern::named(layout, own));
    }
    ASSERT_EQ(options.palette.size(), 190U);
    options.uniform_paintings = 180;
    Preparation first = prepare(planted.project, nullptr, planted.target, options, 2);
    Trials trials(std::move(first.parts));
    EXPECT_GE(extend_palette(trials, first.whole, options).coordinates.cols(), 180);
}

/// Half of the distance of the best single pattern, with three of these and a few steps.
TEST(Search, MakesAUsefulPaintingSoon) {
    const Planted planted;
    const DesignOptions options = test::design_options(planted.project);
    Preparation preparation = prepare(planted.project, nullptr, planted.target, options);
    Trials trials(std::move(preparation.parts));
    const TimeLimit time(0.0);
    DesignReport report;
    Search search(trials, options, time, report);
    const Search::Beginning beginning = search.begin(preparation.palette);
    ASSERT_TRUE(beginning.painted);
    EXPECT_LE(trials.solutions(), 10);
    const std::vector<Solved> uniform =
        search.try_uniform(preparation.palette, preparation.coordinates, beginning.uniform);
    EXPECT_EQ(uniform.size(), test::kDesignPatterns.size());
    EXPECT_EQ(report.uniform_tried, test::kDesignPatterns.size());
    EXPECT_LT(beginning.painted->trial.objective, 0.25 * uniform.front().trial.objective);
}

/// A point that is worse than the start of a search is none to show, though it is the first of its search.
TEST(Search, NotesNoPointThatIsWorseThanItsStart) {
    const Planted planted;
    std::vector<double> shown;
    DesignOptions options = test::design_options(planted.project);
    options.on_better = [&](const DesignProgress& progress) { shown.push_back(progress.misfit); };
    Preparation preparation = prepare(planted.project, nullptr, planted.target, options);
    Trials trials(std::move(preparation.parts));
    const TimeLimit time(0.0);
    DesignReport report;
    Search search(trials, options, time, report);
    Solved start{trials.uniform(0), {}};
    start.trial.objective = 0.5;
    search.begin_at(start);
    Solved worse{trials.uniform(1), {}};
    worse.trial.objective = 0.75;
    search.note(worse);
    EXPECT_FALSE(search.best_point());
    EXPECT_TRUE(shown.empty());
    Solved better{trials.uniform(2), {}};
    better.trial.objective = 0.25;
    search.note(better);
    EXPECT_EQ(search.best_point(), better.point);
    EXPECT_EQ(shown, std::vector<double>{0.5});
}

/// A load in the plane, far above the one at which the strip buckles: no painting has a stable equilibrium.
TEST(Search, KeepsAPointThatItDoesNotFindAgain) {
    Planted planted;
    planted.project.load_cases = {test::cantilever({-1.0, 0.0, 0.0})};
    DesignOptions options = test::design_options(planted.project);
    options.most_solutions = 8;
    Preparation preparation = prepare(planted.project, nullptr, planted.target, options);
    Trials trials(std::move(preparation.parts));
    const TimeLimit time(0.0);
    DesignReport report;
    Search search(trials, options, time, report);
    search.set_columns({0, 1}, {0, 1});
    Solved start{trials.uniform(0), {}};
    start.trial.is_found = true;  // as if another path had led there
    start.trial.objective = 0.25;
    ASSERT_FALSE(trials.solve(start.point, {}).is_found);
    EXPECT_EQ(search.improve(start, 0.0).trial.objective, 0.25);
    EXPECT_EQ(search.improve_from_others(start, {}, 0.0, 0).trial.objective, 0.25);
}

/// The uniform painting that is too heavy reaches the target.
TEST(Search, ReplacesNoLightPaintingByAHeavyStart) {
    const Planted planted;
    simulation::Project hidden = planted.project;
    test::paint_graded(hidden, {test::kDesignPatterns.back()});
    Trials trials = test::trials_of(planted.project, test::target_of(hidden));
    const auto solved = [&](std::size_t pattern) {
        const Point point = trials.uniform(pattern);
        return Solved{point, trials.solve(point, {})};
    };
    const Solved heavy = solved(test::kDesignPatterns.size() - 1);
    const Solved light = solved(0);
    ASSERT_TRUE(heavy.trial.is_found && light.trial.is_found);
    ASSERT_LT(heavy.trial.objective, light.trial.objective);
    DesignOptions options = test::design_options(planted.project);
    options.max_mass = 0.5 * (trials.mass_of(light.point) + trials.mass_of(heavy.point));
    options.most_solutions = trials.solutions() + 1;  // the heavy start is solved again
    const TimeLimit time(0.0);
    DesignReport report;
    Search search(trials, options, time, report);
    search.set_columns({0, 1, 2, 3, 4}, {0, 1, 2, 3, 4});
    const Solved found = search.improve_from_others(light, {light, heavy}, 0.0, 0);
    EXPECT_EQ(report.start_misfits.size(), 1U);
    EXPECT_LE(trials.mass_of(found.point), options.max_mass);
}

}  // namespace THIS_TEST
}  // namespace fretwork::design::detail
