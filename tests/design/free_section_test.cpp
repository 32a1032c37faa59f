// SPDX-License-Identifier: GPL-3.0-or-later
#include "support.hpp"
#include "trials_of.hpp"

#include <fretwork/design/checks/designed_project.hpp>
#include <fretwork/design/search/free_section.hpp>
#include <fretwork/mechanics/frame/section.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace fretwork::design::detail {
namespace THIS_TEST {

using test::complaint_of;
using testing::HasSubstr;

constexpr FreeUnknowns kSection{.width = true, .thickness = true};

/// By central differences of solved surfaces; gravity changes with the section, too.
TEST(FreeSection, WidthAndThicknessHaveTheDerivativesOfTheResiduals) {
    simulation::Project project = test::cantilever_project(4, 3, 0.04);
    project.load_cases.front().gravity = {0.0, 0.0, -9.0};
    Trials trials = test::trials_of(project, test::bent(1.0), kSection);
    const Point point = test::random_painting(trials, 6);
    ASSERT_EQ(point.unknowns.size(), 2);
    const Trial trial = trials.solve(point, {});
    const SwapTable table = trials.table(point, trial, {0, 1, 2, 3, 4}, 1, {});
    test::expect_derivatives(trials, point, table, 1e-4 * point.unknowns);
}

/// With the bars of a point, whatever they were before: a surface of these bars from nothing.
TEST(FreeSection, TablesAreThoseOfTheBarsAsTheyAre) {
    const simulation::Project project = test::cantilever_project(3, 3, 0.02);
    Trials trials = test::trials_of(project, test::bent(1.0), kSection);
    Point point = test::random_painting(trials, 3);
    point.unknowns << 0.0015, 0.0024;
    const Trial trial = trials.solve(point, {});
    simulation::Project other = project;
    other.setting = with_section(*project.setting, 0.0015, 0.0024);
    Trials fresh = test::trials_of(other, test::bent(1.0));
    Point same = point;
    same.unknowns = Eigen::VectorXd();
    const Trial expected = fresh.solve(same, {});
    EXPECT_NEAR(trial.objective, expected.objective, 1e-7 * expected.objective);
    EXPECT_NEAR(trials.mass_of(point), fresh.mass_of(same), 1e-12);
    const auto own = trials.table(point, trial, {0, 4}, 1, {});
    const auto wanted = fresh.table(same, expected, {0, 4}, 1, {});
    EXPECT_NEAR(own.masses.sum(), wanted.masses.sum(), 1e-12);
    EXPECT_NEAR(own.energies.sum(), wanted.energies.sum(), 1e-6 * wanted.energies.sum());
}

TEST(FreeSection, BarsKeepSomeWidthAndThickness) {
    const Trials trials = test::trials_of(test::cantilever_project(2, 2, 0.02), test::bent(1.0), kSection);
    const Eigen::Vector2d bounded = trials.bounded(Eigen::Vector2d(0.0, 1.0));
    EXPECT_NEAR(bounded[0], 0.002 / 3.0, 1e-12);
    EXPECT_NEAR(bounded[1], 0.006, 1e-12);
}

TEST(FreeSection, RefusesOtherSections) {
    EXPECT_THAT(complaint_of([] { require_rectangle(mechanics::circle_section(0.002)); }),
                HasSubstr("circle"));
    mechanics::Section odd = mechanics::rectangle_section(0.002, 0.003);
    odd.J *= 2.0;
    EXPECT_THAT(complaint_of([&] { require_rectangle(odd); }), HasSubstr("no rectangle"));
    // Half the area, with the torsion constant that belongs to its radii of gyration.
    odd = mechanics::rectangle_section(0.002, 0.003);
    odd.area /= 2.0;
    odd.J = mechanics::rectangle_section(mechanics::rectangle_width(odd), mechanics::rectangle_height(odd)).J;
    EXPECT_THAT(complaint_of([&] { require_rectangle(odd); }), HasSubstr("no rectangle"));
    require_rectangle(mechanics::rectangle_section(0.002, 0.003));
}

/// The search may leave the bars as they are.
TEST(FreeSection, OnlyOtherBarsPartTheProjectFromItsLibrary) {
    simulation::Project project = test::cantilever_project(2, 2, 0.02);
    project.library_path = "bars.db";
    const Trials trials = test::trials_of(project, test::bent(1.0), kSection);
    const auto designed = [&](const Eigen::VectorXd& unknowns) {
        Point point = trials.uniform(0);
        point.unknowns = unknowns;
        DesignReport report;
        report.project = project;
        write_point(trials, point, {project.load_cases.front().name}, report);
        return report;
    };
    const DesignReport same = designed(trials.initial_unknowns());
    EXPECT_EQ(same.project.library_path, "bars.db");
    EXPECT_TRUE(same.warnings.empty());
    EXPECT_EQ(same.project.setting->section, project.setting->section);
    EXPECT_NEAR(same.width.value(), 0.002, 1e-12);
    const DesignReport wider = designed(1.001 * trials.initial_unknowns());
    EXPECT_TRUE(wider.project.library_path.empty());
    EXPECT_EQ(wider.warnings.size(), 1U);
    EXPECT_NEAR(mechanics::rectangle_width(wider.project.setting->section), 0.002002, 1e-12);
}

/// Hidden: bars of another thickness under one pattern. One pattern is the best single one: no design.
TEST(FreeSection, ThicknessOfASinglePatternIsFoundAndIsNoBetterDesign) {
    const simulation::Project project = test::cantilever_project(5, 3, 0.02);
    simulation::Project hidden = project;
    hidden.setting = with_section(*project.setting, 0.002, 0.0024);
    test::paint_graded(hidden, {test::kDesignPatterns[1]});
    DesignOptions options = test::design_options(project, {test::kDesignPatterns[1]});
    options.free_thickness = true;
    const DesignReport report = design::design(project, nullptr, test::target_of(hidden), options);
    ASSERT_TRUE(report.thickness);
    EXPECT_NEAR(*report.thickness, 0.0024, 2e-6);
    EXPECT_NEAR(*report.width, 0.002, 1e-12);
    EXPECT_NEAR(mechanics::rectangle_height(report.project.setting->section), *report.thickness, 1e-12);
    EXPECT_FALSE(report.is_better());
}

/// A graded painting of thinner and wider bars. Width bends little out of plane, so the load is across, too.
TEST(FreeSection, PlantedWidthAndThicknessBringThePaintingNear) {
    simulation::Project project = test::cantilever_project(6, 4, 0.02);
    simulation::Project hidden = project;
    hidden.setting = with_section(*project.setting, 0.0026, 0.0017);
    test::paint_graded(hidden, test::kDesignPatterns);
    const Target target = test::target_of(hidden);
    DesignOptions options = test::design_options(project);
    const DesignReport fixed = design::design(project, nullptr, target, options);
    options.free_width = options.free_thickness = true;
    const DesignReport report = design::design(project, nullptr, target, options);
    EXPECT_LT(report.error->mean, 0.3 * report.best_uniform->mean);
    EXPECT_LT(report.error->mean, fixed.error->mean);
    EXPECT_TRUE(report.is_better());
}

}  // namespace THIS_TEST
}  // namespace fretwork::design::detail
