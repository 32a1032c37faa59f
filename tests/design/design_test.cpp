// SPDX-License-Identifier: GPL-3.0-or-later
#include "hidden.hpp"
#include "stops.hpp"
#include "support.hpp"

#include <fretwork/pattern/mirror.hpp>
#include <fretwork/simulation/project/painting_recipe.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace fretwork::design {
namespace THIS_TEST {

using test::cantilever_project;
using test::complaint_of;
using test::kDesignPatterns;
using testing::HasSubstr;
using tiling::TileIndex;

/// Bent to about half of its length, by a painting that is not known.
struct Planted {
    simulation::Project project = cantilever_project(6, 4, 0.03);
    Target target;
    Planted() {
        simulation::Project hidden = project;
        test::paint_graded(hidden, kDesignPatterns);
        target = test::target_of(hidden);
    }
};

/// The distance of the painting that was written, with all beams, by another way than the report's.
double mean_error(const DesignReport& report, const Target& target) {
    const auto& goal = std::get<NodesGoal>(target.goals.front().what);
    const auto result =
        simulation::simulate(simulation::make_surface(report.project, nullptr),
                             report.project.load_cases.front(), {.model = "full", .threads = 1});
    double sum = 0.0;
    double largest = 0.0;
    for (std::size_t i = 0; i < goal.nodes.size(); ++i) {
        const Eigen::Vector3d wanted(*goal.values[i][0], *goal.values[i][1], *goal.values[i][2]);
        const Eigen::Vector3d found = result.solution.displacements.row(goal.nodes[i]).head<3>().transpose();
        sum += (found - wanted).norm();
        largest = std::max(largest, wanted.norm());
    }
    return sum / static_cast<double>(goal.nodes.size()) / largest;
}

TEST(Design, ComesNearToAPlantedTargetInLargeDisplacements) {
    const Planted planted;
    const DesignReport report =
        design(planted.project, nullptr, planted.target, test::design_options(planted.project));
    ASSERT_TRUE(report.error);
    ASSERT_TRUE(report.best_uniform);
    EXPECT_TRUE(report.error->is_stable);
    EXPECT_NEAR(report.error->mean, mean_error(report, planted.target), 1e-6);
    // 24 tiles with five patterns leave little to compensate with; experiments/inverse_design has larger
    // ones.
    EXPECT_LT(report.error->mean, 0.2 * report.best_uniform->mean);
    EXPECT_TRUE(report.is_better());
    EXPECT_EQ(report.uniform_tried, kDesignPatterns.size());
    for (std::size_t i = 1; i < report.history.size(); ++i) {
        EXPECT_GE(report.history[i].solutions, report.history[i - 1].solutions);
    }
}

TEST(Design, IsTheSameWithAnyNumberOfThreads) {
    const Planted planted;
    DesignOptions options = test::design_options(planted.project);
    options.most_solutions = 12;
    const DesignReport one = design(planted.project, nullptr, planted.target, options);
    options.threads = 3;
    const DesignReport three = design(planted.project, nullptr, planted.target, options);
    EXPECT_EQ(one.error->mean, three.error->mean);
    for (std::size_t t = 0; t < one.project.tessellation.tiles.size(); ++t)
        EXPECT_EQ(one.project.tessellation.tiles[t].pattern, three.project.tessellation.tiles[t].pattern);
}

const pattern::NamedPattern& pattern_of(const simulation::Project& project, TileIndex tile) {
    return *tiling::pattern_of(project.tessellation, tile);
}

TEST(Design, KeepsTilesAndTheNumberOfPatterns) {
    const Planted planted;
    DesignOptions options = test::design_options(planted.project);
    options.keep = {TileIndex(0), TileIndex(7)};
    options.max_patterns = 3;
    const DesignReport report = design(planted.project, nullptr, planted.target, options);
    for (const TileIndex tile : options.keep)
        EXPECT_EQ(pattern_of(report.project, tile).id, pattern_of(planted.project, tile).id);
    EXPECT_LE(report.patterns.size(), 3U);
    EXPECT_EQ(report.patterns.size(), report.project.tessellation.patterns.size());
    EXPECT_LT(report.error->mean, report.best_uniform->mean);
}

TEST(Design, KeepsTheMass) {
    const Planted planted;
    DesignOptions options = test::design_options(planted.project);
    const auto mass_of = [](const simulation::Project& project) {
        double sum = 0.0;
        for (const double mass : simulation::tile_masses(simulation::make_surface(project, nullptr)))
            sum += mass;
        return sum;
    };
    simulation::Project heavy = planted.project;
    test::paint_graded(heavy, {kDesignPatterns.back()});
    options.max_mass = 0.7 * mass_of(heavy);
    const DesignReport report = design(planted.project, nullptr, planted.target, options);
    EXPECT_LE(mass_of(report.project), options.max_mass);
    EXPECT_NEAR(report.mass, mass_of(report.project), 1e-6 * report.mass);
    EXPECT_LT(report.error->mean, report.best_uniform->mean);
    options.max_mass = 0.1 * mass_of(heavy);
    EXPECT_THAT(complaint_of([&] { (void)design(planted.project, nullptr, planted.target, options); }),
                HasSubstr("the lightest painting weighs"));
}

/// 5 columns: the middle one is its own image. Patterns without a mirror image are left out.
TEST(Design, KeepsAMirrorSymmetry) {
    simulation::Project project = cantilever_project(5, 4, 0.03);
    simulation::Project hidden = project;
    test::paint_graded(hidden, kDesignPatterns);
    DesignOptions options = test::design_options(project);
    options.symmetry = {Symmetry::Kind::MirrorX};
    const DesignReport report = design(project, nullptr, test::target_of(hidden), options);
    const pattern::Mirror mirror(project.layout);
    for (int column = 0; column < 2; ++column) {
        for (int row = 0; row < 4; ++row) {
            const auto& left = pattern_of(report.project, TileIndex(5 * row + column));
            const auto& right = pattern_of(report.project, TileIndex(5 * row + 4 - column));
            EXPECT_EQ(pattern::pattern_id(project.layout, *mirror.image(left.pattern)), right.id);
        }
    }
}

/// Of the palette, only 1-6+3-6 is its own mirror image.
TEST(Design, CountsMirrorImagesAmongTheLargestNumberOfPatterns) {
    const simulation::Project project = cantilever_project(5, 4, 0.03);
    simulation::Project hidden = project;
    test::paint_graded(hidden, kDesignPatterns);
    const Target target = test::target_of(hidden);
    DesignOptions options = test::design_options(project, {"0-1+1-6", "0-1+0-6+1-6", "1-6+3-6"});
    options.symmetry = {Symmetry::Kind::MirrorX};
    options.most_solutions = 16;
    for (const std::size_t most : {1U, 2U, 3U, 4U}) {
        options.max_patterns = most;
        EXPECT_LE(design(project, nullptr, target, options).patterns.size(), most);
    }
    options.palette.pop_back();
    options.max_patterns = 1;
    EXPECT_THAT(complaint_of([&] { (void)design(project, nullptr, target, options); }),
                HasSubstr("two of at most 1 pattern, and no pattern"));
}

/// A target with more load: the factor is found, too.
TEST(Design, FindsTheFactorOfTheLoad) {
    const Planted planted;
    simulation::Project weak = planted.project;
    weak.load_cases.front().loads.front().force *= 0.6;
    DesignOptions options = test::design_options(weak);
    const DesignReport fixed = design(weak, nullptr, planted.target, options);
    options.free_factor = true;
    const DesignReport report = design(weak, nullptr, planted.target, options);
    // The single pattern has its own best factor, too.
    EXPECT_LT(report.error->mean, 0.25 * report.best_uniform->mean);
    EXPECT_LT(report.error->mean, fixed.error->mean);
    EXPECT_NEAR(report.error->mean, mean_error(report, planted.target), 1e-6)
        << "the load case is written, too";
    EXPECT_NE(report.factors.front(), 1.0);
}

TEST(Design, TakesTheTilesThatItPaintsOutOfTheirRecipes) {
    Planted planted;
    const simulation::PaintByField field{.field = simulation::FieldExpression{"u"},
                                         .palette = {.ids = kDesignPatterns}};
    (void)simulation::paint(planted.project, field, nullptr);
    DesignOptions options = test::design_options(planted.project);
    options.keep = {TileIndex(0), TileIndex(1)};
    const DesignReport report = design(planted.project, nullptr, planted.target, options);
    ASSERT_EQ(report.project.recipes.size(), 1U);
    const auto& tiles = report.project.recipes[0].tiles;
    for (const TileIndex tile : report.project.tessellation.tiles.indices()) {
        const bool is_as_before = pattern_of(report.project, tile).id == pattern_of(planted.project, tile).id;
        EXPECT_EQ(std::ranges::find(tiles, tile) != tiles.end(), is_as_before) << tile.value;
    }
    EXPECT_LT(tiles.size(), report.project.tessellation.tiles.size());
}

/// A target under each of two load cases, which one painting reaches.
Planted two_load_cases() {
    Planted planted;
    simulation::LoadCase second = test::cantilever({0.0, 0.01, -0.02});
    second.name = "second";
    planted.project.load_cases.push_back(second);
    simulation::Project hidden = planted.project;
    test::paint_graded(hidden, kDesignPatterns);
    std::swap(hidden.load_cases[0], hidden.load_cases[1]);
    Goal goal = test::target_of(hidden).goals.front();
    goal.load_case = "second";
    planted.target.goals.push_back(goal);
    return planted;
}

TEST(Design, ServesTwoLoadCasesWithOnePainting) {
    const Planted planted = two_load_cases();
    const DesignReport report =
        design(planted.project, nullptr, planted.target, test::design_options(planted.project));
    EXPECT_EQ(report.load_cases, (std::vector<std::string>{"cantilever", "second"}));
    EXPECT_LT(report.error->mean, 0.15 * report.best_uniform->mean);
}

TEST(Design, TakesTheOnlyLoadCaseOnceWhetherItIsNamedOrNot) {
    Planted planted;
    planted.target.goals.push_back(planted.target.goals.front());
    planted.target.goals.back().load_case = "cantilever";
    DesignOptions options = test::design_options(planted.project);
    options.load_case.clear();
    options.most_solutions = 6;
    const DesignReport report = design(planted.project, nullptr, planted.target, options);
    EXPECT_EQ(report.load_cases, std::vector<std::string>{"cantilever"});
    EXPECT_EQ(report.shapes.size(), 1U);
}

/// Whenever it is stopped: nothing, or a whole painting that is no worse than what it began with.
TEST(Design, KeepsTheBestPaintingWhenItIsStopped) {
    const Planted planted;
    DesignOptions options = test::design_options(planted.project);
    options.most_solutions = 10;
    const test::StopAtLook never;
    options.control = never.control();
    (void)design(planted.project, nullptr, planted.target, options);
    const std::size_t looks = never.looks();
    int kept = 0;
    for (std::size_t i = 0; i < 12; ++i) {
        const test::StopAtLook stop(looks * i / 12);
        options.control = stop.control();
        try {
            const DesignReport report = design(planted.project, nullptr, planted.target, options);
            EXPECT_EQ(report.end, DesignEnd::Stopped);
            for (const tiling::Tile& tile : report.project.tessellation.tiles) EXPECT_GE(tile.pattern, 0);
            ++kept;
        } catch (const base::Stopped&) {
            EXPECT_EQ(kept, 0) << "there was a painting before";
        }
    }
    EXPECT_GE(kept, 4);
}

/// The first painting follows three single patterns. Just before each better one, a stop still gives a
/// painting of several patterns.
TEST(Design, ReturnsNoSinglePatternWhenItIsStoppedAfterAPainting) {
    const Planted planted;
    DesignOptions options = test::design_options(planted.project);
    std::vector<std::size_t> looks;
    const test::StopAtLook never;
    options.control = never.control();
    options.on_better = [&](const DesignProgress& progress) {
        if (progress.solutions > 3) looks.push_back(never.looks());
    };
    (void)design(planted.project, nullptr, planted.target, options);
    options.on_better = {};
    ASSERT_GT(looks.size(), 1U);
    for (std::size_t i = 1; i < std::min<std::size_t>(looks.size(), 7); ++i) {
        const test::StopAtLook stop(looks[i] - 1);
        options.control = stop.control();
        const DesignReport report = design(planted.project, nullptr, planted.target, options);
        EXPECT_EQ(report.end, DesignEnd::Stopped);
        EXPECT_GT(report.patterns.size(), 1U) << i;
    }
}

TEST(Design, KeepsToTheNumberOfSolutions) {
    const Planted planted;
    DesignOptions options = test::design_options(planted.project);
    for (const int most : {1, 2, 4, 5, 6, 7, 9, 13}) {
        options.most_solutions = most;
        const DesignReport report = design(planted.project, nullptr, planted.target, options);
        EXPECT_LE(report.solutions, most);
        EXPECT_LE(report.uniform_tried, static_cast<std::size_t>(most));
        EXPECT_TRUE(report.error) << "what is found is checked";
        if (most <= 5) {
            EXPECT_EQ(report.end, DesignEnd::SolutionsSpent) << "five single patterns take all";
        }
    }
}

/// One painting takes a solution for each load case.
TEST(Design, KeepsToTheNumberOfSolutionsOfTwoLoadCases) {
    const Planted planted = two_load_cases();
    DesignOptions options = test::design_options(planted.project);
    options.most_solutions = 1;
    EXPECT_THAT(complaint_of([&] { (void)design(planted.project, nullptr, planted.target, options); }),
                HasSubstr("at most 1 nonlinear solution tries no painting: the target has 2 load cases"));
    for (const int most : {2, 3, 11, 14}) {
        options.most_solutions = most;
        EXPECT_LE(design(planted.project, nullptr, planted.target, options).solutions, most);
    }
}

TEST(Design, RefusesWhatDoesNotFit) {
    const Planted planted;
    const auto complaint = [&](const auto& edit) {
        DesignOptions options = test::design_options(planted.project);
        simulation::Project project = planted.project;
        Target target = planted.target;
        edit(options, project, target);
        return complaint_of([&] { (void)design(project, nullptr, target, options); });
    };
    using Project = simulation::Project;
    EXPECT_THAT(complaint([](DesignOptions& o, Project&, Target&) { o.palette.clear(); }),
                HasSubstr("palette"));
    EXPECT_THAT(complaint([](DesignOptions& o, Project&, Target&) { o.palette.push_back(o.palette[1]); }),
                HasSubstr("the pattern 0-1+1-6 twice"));
    EXPECT_THAT(complaint([](DesignOptions& o, Project&, Target&) { o.load_case = "rain"; }),
                HasSubstr("rain"));
    EXPECT_THAT(complaint([](DesignOptions& o, Project&, Target&) { o.keep = {TileIndex(99)}; }),
                HasSubstr("no tile 99"));
    EXPECT_THAT(complaint([](DesignOptions& o, Project& p, Target&) {
                    for (const TileIndex tile : p.tessellation.tiles.indices()) o.keep.push_back(tile);
                }),
                HasSubstr("nothing to paint"));
    EXPECT_THAT(complaint([](DesignOptions& o, Project&, Target&) {
                    o.symmetry = {Symmetry::Kind::Turn, 3};
                }),
                HasSubstr("has no image"));
    EXPECT_THAT(complaint([](DesignOptions& o, Project&, Target&) {
                    o.keep = {TileIndex(0)};
                    o.max_patterns = 1;
                    o.palette.erase(o.palette.begin() + 1);
                }),
                HasSubstr("already"));
    EXPECT_THAT(complaint([](DesignOptions& o, Project&, Target&) { o.free_prescribed = true; }),
                HasSubstr("prescribes no displacement"));
    EXPECT_THAT(complaint([](DesignOptions& o, Project& p, Target&) {
                    o.free_factor = true;
                    p.load_cases.front().loads.clear();
                    p.load_cases.front().gravity = {0.0, 0.0, -9.81};
                }),
                HasSubstr("has no load besides its weight"));
    EXPECT_THAT(complaint([](DesignOptions&, Project&, Target& t) {
                    auto& goal = std::get<NodesGoal>(t.goals.front().what);
                    for (auto& value : goal.values) value = {0.0, 0.0, 0.0};
                }),
                HasSubstr("asks for no displacement"));
}

}  // namespace THIS_TEST
}  // namespace fretwork::design
