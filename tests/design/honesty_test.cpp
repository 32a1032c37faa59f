// SPDX-License-Identifier: GPL-3.0-or-later
// What a design is compared with, what it refuses, and what it warns of.
#include "hidden.hpp"
#include "support.hpp"

#include <fretwork/design/design_words.hpp>
#include <fretwork/pattern/enumerate.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

namespace fretwork::design {
namespace THIS_TEST {

using test::complaint_of;
using test::kDesignPatterns;
using testing::AllOf;
using testing::HasSubstr;
using tiling::TileIndex;

const simulation::NodesInBox kAll{{-10, -10, 10, 10}};

simulation::Project small_project() {
    return test::cantilever_project(4, 3, 0.02);
}

Target planted(const simulation::Project& project) {
    simulation::Project hidden = project;
    test::paint_graded(hidden, kDesignPatterns);
    return test::target_of(hidden);
}

/// The factor is free for the single patterns, too: of a weak load, a palette of one is no design.
TEST(DesignHonesty, APaletteOfOnePatternIsNoBetterThanThatPattern) {
    simulation::Project weak = small_project();
    const Target target = planted(weak);
    weak.load_cases.front().loads.front().force *= 0.4;
    DesignOptions options = test::design_options(weak, {kDesignPatterns[2]});
    options.free_factor = true;
    const DesignReport report = design(weak, nullptr, target, options);
    EXPECT_NE(report.factors.front(), 1.0);
    EXPECT_EQ(report.patterns.size(), 1U);
    EXPECT_FALSE(report.is_better());
    EXPECT_NEAR(report.error->mean, report.best_uniform->mean, 1e-12);
}

TEST(DesignHonesty, SinglePatternsAreComparedWithTheirOwnBestFactor) {
    simulation::Project weak = small_project();
    const Target target = planted(weak);
    weak.load_cases.front().loads.front().force *= 0.4;
    DesignOptions options = test::design_options(weak);
    const DesignReport fixed = design(weak, nullptr, target, options);
    options.free_factor = true;
    const DesignReport report = design(weak, nullptr, target, options);
    EXPECT_LT(report.best_uniform->mean, 0.5 * fixed.best_uniform->mean);
    EXPECT_TRUE(report.is_better());
}

TEST(DesignHonesty, ReportsWhereItsNodesAreAndWhereTheyShallBe) {
    const simulation::Project project = small_project();
    DesignOptions options = test::design_options(project);
    options.most_solutions = 12;
    const DesignReport report = design(project, nullptr, planted(project), options);
    ASSERT_EQ(report.shapes.size(), 1U);
    ASSERT_EQ(report.uniform_shapes.size(), 1U);
    double sum = 0.0;
    double largest = 0.0;
    for (const CaseShape::GoalNode& goal : report.shapes.front().goals) {
        const auto& place = project.tessellation.interface_nodes[tiling::InterfaceIndex(goal.node)];
        const Eigen::Vector3d rest(place.x, place.y, 0.0);
        const Eigen::Vector3d there =
            rest + report.shapes.front().displacements.row(goal.node).head<3>().transpose();
        EXPECT_NEAR((goal.wanted - there).norm(), goal.distance, 1e-12);
        sum += goal.distance;
        largest = std::max(largest, (goal.wanted - rest).norm());
    }
    const auto count = static_cast<double>(report.shapes.front().goals.size());
    EXPECT_NEAR(sum / count / largest, report.error->mean, 1e-9);
    EXPECT_FALSE(report.gamut.reached.empty());
    EXPECT_EQ(report.gamut.wanted.size(), project.tessellation.tiles.size());
    EXPECT_EQ(report.gamut.designed.size(), report.gamut.wanted.size());
}

TEST(DesignHonesty, ATargetFarBeyondTheLoadIsOutOfReach) {
    const simulation::Project project = test::cantilever_project(4, 3, 1e-7);
    const Target target{"", "", {{FormulaGoal{kAll, {std::nullopt, std::nullopt, "0.05*x^2"}}}}};
    const DesignReport report = design(project, nullptr, target, test::design_options(project));
    EXPECT_EQ(report.end, DesignEnd::Unreachable);
    ASSERT_TRUE(report.bound);
    // Misfits are root mean squares: that of the flat surface is 0.47, since few nodes have far to go.
    EXPECT_GT(*report.bound, 0.4);
    ASSERT_TRUE(report.reach_of_ten_loads);
    EXPECT_LT(*report.reach_of_ten_loads, 1.0);
    EXPECT_TRUE(report.error) << "the painting that is written is checked";
}

/// A honeycomb whose tiles all differ from each other; its columns and rows stay straight.
simulation::Project squeezed_project(int columns, int rows) {
    simulation::Project project = test::cantilever_project(columns, rows, 1e-7);
    tiling::Tessellation& own = project.tessellation;
    for (geometry::Point2& place : own.vertices)
        place = {place.x - 0.3 * place.x * place.x, place.y - 0.4 * place.y * place.y};
    for (const tiling::Tile& tile : own.tiles) {
        for (std::size_t k = 0; k < tile.vertices.size(); ++k) {
            const geometry::Point2& a = own.vertices[tile.vertices[k]];
            const geometry::Point2& b = own.vertices[tile.vertices[(k + 1) % tile.vertices.size()]];
            own.interface_nodes[tile.interface_nodes[k]] = {(a.x + b.x) / 2, (a.y + b.y) / 2};
        }
    }
    return project;
}

/// 8,000 condensations are 163 patterns of 49 different tiles.
TEST(DesignHonesty, GivesNoBoundOfAPaletteThatWasCut) {
    const simulation::Project project = squeezed_project(7, 7);
    const Target target{"", "", {{FormulaGoal{kAll, {std::nullopt, std::nullopt, "1e-3*x^2"}}}}};
    DesignOptions options = test::design_options(project);
    options.most_solutions = 6;
    options.uniform_paintings = 3;
    EXPECT_TRUE(design(project, nullptr, target, options).bound);
    options.palette.clear();
    for (const pattern::Pattern& own : pattern::enumerate_patterns(project.layout)) {
        if (options.palette.size() < 200) options.palette.push_back(pattern::named(project.layout, own));
    }
    EXPECT_FALSE(design(project, nullptr, target, options).bound);
}

TEST(DesignHonesty, SaysThatNothingMoves) {
    simulation::Project project = small_project();
    project.load_cases.front().loads.front().force.setZero();
    const DesignReport report =
        design(project, nullptr, planted(small_project()), test::design_options(project));
    EXPECT_TRUE(report.nothing_moves);
    EXPECT_EQ(report.wanted_of_softest, 0.0);
    EXPECT_FALSE(report.reach_of_ten_loads);
}

TEST(DesignHonesty, WarnsOfGoalsForHeldNodes) {
    const simulation::Project project = small_project();
    Target target = planted(project);
    target.goals = {{FormulaGoal{kAll, {std::nullopt, std::nullopt, "0.02"}}}};
    DesignOptions options = test::design_options(project);
    options.most_solutions = 6;
    const DesignReport report = design(project, nullptr, target, options);
    ASSERT_EQ(report.warnings.size(), 1U);
    EXPECT_THAT(plain_text(report.warnings.front()),
                AllOf(HasSubstr("/goals/0 wants uz = 20 mm of node"), HasSubstr("held at uz = 0 mm"),
                      HasSubstr("of its nodes are held elsewhere")));
    EXPECT_THAT(report.warnings.front().text, HasSubstr("wants uz = {0} of node"));
    EXPECT_EQ(report.warnings.front().values.front().value, 0.02);
    EXPECT_EQ(plain_text(WarnedValue{0.25, WarnedValue::Quantity::Angle}), "14.32 deg");
}

/// The limit is kept with the error of one element a beam, and one without that is not kept.
TEST(DesignHonesty, ComparesUtilizationWithItsErrorToTheLimit) {
    simulation::Project project = small_project();
    project.setting->strength = 50e6;
    DesignOptions options = test::design_options(project);
    options.most_solutions = 6;
    const DesignReport any = design(project, nullptr, planted(project), options);
    ASSERT_TRUE(any.largest_utilization);
    EXPECT_FALSE(any.utilization_error) << "nobody asked";
    EXPECT_TRUE(any.keeps_utilization(options));
    options.max_utilization = *any.largest_utilization;
    const DesignReport limited = design(project, nullptr, planted(project), options);
    ASSERT_TRUE(limited.utilization_error);
    EXPECT_GT(*limited.utilization_error, 0.0);
    EXPECT_EQ(limited.keeps_utilization(options),
              *limited.largest_utilization + *limited.utilization_error <= options.max_utilization);
    EXPECT_FALSE(keeps_utilization(options, options.max_utilization, 1e-3));
    EXPECT_FALSE(keeps_utilization(options, 0.1, std::nullopt)) << "of unknown error";
    EXPECT_TRUE(keeps_utilization(options, 0.5 * options.max_utilization, 0.1 * options.max_utilization));
}

TEST(DesignHonesty, ALimitOfUtilizationNeedsAStrength) {
    simulation::Project project = small_project();
    project.setting->strength.reset();
    DesignOptions options = test::design_options(project);
    options.max_utilization = 0.5;
    EXPECT_THROW((void)design(project, nullptr, planted(project), options), base::InputError);
}

/// Where mixtures of patterns leave much, the load and the patterns limit the result; planted targets are
/// within reach of them.
TEST(DesignHonesty, SaysWhatMixturesOfPatternsArePredictedToReach) {
    const simulation::Project project = small_project();
    const Target near = planted(project);
    const DesignReport report = design(project, nullptr, near, test::design_options(project));
    ASSERT_TRUE(report.relaxed);
    EXPECT_LT(*report.relaxed, report.best_uniform->mean);
    // Tip force and clamp cannot twist a strip.
    Target twist = near;
    twist.goals = {{FormulaGoal{kAll, {"0", "0", "2*x*(y-0.05)"}}}};
    const DesignReport far = design(project, nullptr, twist, test::design_options(project));
    ASSERT_TRUE(far.relaxed);
    EXPECT_GT(*far.relaxed, 10.0 * *report.relaxed);
}

std::string complaint(const simulation::Project& project, const Target& target,
                      const DesignOptions& options) {
    return complaint_of([&] { (void)design(project, nullptr, target, options); });
}

TEST(DesignHonesty, RefusesGoalsThatContradictEachOther) {
    const simulation::Project project = small_project();
    Target target = planted(project);
    target.goals.push_back({NodesGoal{{5}, {}, {{std::nullopt, std::nullopt, 0.5}}}});
    EXPECT_THAT(complaint(project, target, test::design_options(project)),
                AllOf(HasSubstr("/goals/1: wants uz = 500 mm of node 5"), HasSubstr("/goals/0 wants")));
    target.goals.back() = target.goals.front();
    DesignOptions options = test::design_options(project);
    options.most_solutions = 6;
    EXPECT_NO_THROW((void)design(project, nullptr, target, options)) << "the same goal twice is none";
}

TEST(DesignHonesty, RefusesGoalsOutOfAllBounds) {
    const simulation::Project project = small_project();
    const auto of = [&](Goal goal) {
        return complaint(project, {"", "", {std::move(goal)}}, test::design_options(project));
    };
    EXPECT_THAT(of({FormulaGoal{kAll, {"0", "0", "1e9"}}}),
                AllOf(HasSubstr("/goals/0: asks for a displacement of 1e+12 mm"), HasSubstr("metres")));
    EXPECT_THAT(of({RotationGoal{kAll, {3.0, 1.0, std::nullopt}}}),
                AllOf(HasSubstr("/goals/0: /rotation"), HasSubstr("half a turn")));
    EXPECT_THAT(of({RotationGoal{kAll, {0.1, 0.0, 0.0}}, 1e-320}), HasSubstr("/goals/0: /weight"));
}

TEST(DesignHonesty, NamesTheGoalOfAnUnknownLoadCase) {
    const simulation::Project project = small_project();
    Target target = planted(project);
    target.goals.front().load_case = "rain";
    DesignOptions options = test::design_options(project);
    EXPECT_THAT(complaint(project, target, options), AllOf(HasSubstr("/goals/0/case"), HasSubstr("rain")));
    target.goals.front().load_case = "cantilever";
    options.load_case = "snow";
    EXPECT_THAT(complaint(project, target, options), HasSubstr("snow")) << "also where no goal asks for it";
}

/// The project is as it was: a combination has no loads of its own that could be written.
TEST(DesignHonesty, RefusesToDissolveACombination) {
    simulation::Project project = small_project();
    simulation::LoadCase both;
    both.name = "both";
    both.combines = {{"cantilever", 1.5}};
    project.load_cases.push_back(both);
    const Target target = planted(project);
    DesignOptions options = test::design_options(project);
    options.load_case = "both";
    options.most_solutions = 6;
    EXPECT_EQ(design(project, nullptr, target, options).project.load_cases, project.load_cases);
    options.free_factor = true;
    EXPECT_THAT(complaint(project, target, options),
                AllOf(HasSubstr("load case 'both' combines 'cantilever'"), HasSubstr("no factor")));
}

TEST(DesignHonesty, TakesThePatternsOfKeptTilesWhereThereMayBeNoOthers) {
    simulation::Project project = small_project();
    test::paint_graded(project, {kDesignPatterns[0], kDesignPatterns[3]});
    DesignOptions options = test::design_options(project);
    options.keep = {TileIndex(0), TileIndex(8)};
    options.max_patterns = 2;
    options.most_solutions = 20;
    std::set<std::string> kept;
    for (const TileIndex tile : options.keep) kept.insert(tiling::pattern_of(project.tessellation, tile)->id);
    ASSERT_EQ(kept.size(), 2U);
    const DesignReport report = design(project, nullptr, planted(small_project()), options);
    for (const std::string& id : report.patterns) EXPECT_TRUE(kept.contains(id)) << id;
    options.palette = test::design_options(project, {kDesignPatterns[1]}).palette;
    EXPECT_THAT(complaint(project, planted(small_project()), options),
                AllOf(HasSubstr("already"), HasSubstr("none of these is in the palette")));
    options.max_patterns = 1;
    EXPECT_THAT(complaint(project, planted(small_project()), options), HasSubstr("2 patterns already"));
}

TEST(DesignHonesty, NamesTheLightestPatternWhereTheMassIsTooSmall) {
    const simulation::Project project = small_project();
    DesignOptions options = test::design_options(project);
    options.max_mass = 1e-6;
    EXPECT_THAT(complaint(project, planted(project), options), HasSubstr("its lightest pattern is 0-6"));
}

TEST(DesignHonesty, WarnsOfAPaintingThatIsTooHeavy) {
    DesignReport report;
    report.mass = 0.0123;
    DesignOptions options;
    EXPECT_TRUE(design_warnings(report, options).empty());
    options.max_mass = 0.02;
    EXPECT_TRUE(design_warnings(report, options).empty());
    options.max_mass = 0.01;
    const auto texts = plain_texts(design_warnings(report, options));
    ASSERT_EQ(texts.size(), 1U);
    EXPECT_EQ(
        texts.front(),
        "no painting that was checked weighs at most 0.01 kg: the one that was written weighs 0.0123 kg");
}

TEST(DesignHonesty, WarnsOfALoadThatIsTooSmallUnlessItsFactorIsFree) {
    DesignReport report;
    report.uniform_tried = 4;
    report.wanted_of_softest = 12.0;
    DesignOptions options;
    const auto texts = plain_texts(design_warnings(report, options));
    ASSERT_EQ(texts.size(), 1U);
    EXPECT_THAT(texts.front(),
                HasSubstr("12 times the displacement of the softest of the 4 single patterns"));
    options.free_factor = true;
    EXPECT_TRUE(design_warnings(report, options).empty()) << "the search has chosen another load";
    options.free_factor = false;
    options.free_prescribed = true;
    EXPECT_TRUE(design_warnings(report, options).empty()) << "it has moved supports by other values";
}

/// Bars of 2 mm in hexagons of 26 mm: a clearance that only the sparse patterns keep.
TEST(DesignHonesty, LeavesOutPatternsThatDoNotKeepTheClearance) {
    const simulation::Project project = small_project();
    DesignOptions options = test::design_options(project);
    options.most_solutions = 12;
    options.clearance = 0.0;
    EXPECT_EQ(design(project, nullptr, planted(project), options).close_bars, 0U);
    options.clearance = 1.0;
    EXPECT_THAT(complaint(project, planted(project), options), HasSubstr("1000 mm"));
}

}  // namespace THIS_TEST
}  // namespace fretwork::design
