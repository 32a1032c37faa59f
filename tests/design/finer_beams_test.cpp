// SPDX-License-Identifier: GPL-3.0-or-later
#include "hidden.hpp"

#include <fretwork/design/checks/finer_beams.hpp>
#include <fretwork/simulation/results/beam_table.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace fretwork::design::detail {
namespace THIS_TEST {

simulation::Project bent_project() {
    simulation::Project project = test::cantilever_project(4, 2, 0.05);
    test::paint_graded(project, test::kDesignPatterns);
    return project;
}

double stress_with(const simulation::Project& project, int elements) {
    return largest_stress(simulation::make_surface(project, nullptr), project.load_cases.front(),
                          {.elements = elements, .threads = 1}, {})
        .value();
}

/// The table of beams is another way to the same stresses.
TEST(FinerBeams, HaveTheStressesOfTheSurfaceWithOneElementABeam) {
    const simulation::Project project = bent_project();
    simulation::Session session(simulation::make_surface(project, nullptr), project.load_cases.front(),
                                {.model = "full", .threads = 1});
    const auto result = session.solve();
    double largest = 0.0;
    for (const auto& row : simulation::beam_table(session, result.solution).rows)
        largest = std::max(largest, row.largest_von_mises());
    EXPECT_NEAR(stress_with(project, 1), largest, 1e-6 * largest);
}

/// The estimate of the error of one element, 4/3 of the difference to two, is at least half of the difference
/// to sixteen elements, of which little is left to come.
TEST(FinerBeams, ShowTheErrorOfOneElementABeam) {
    const simulation::Project project = bent_project();
    const double one = stress_with(project, 1);
    const double error = std::abs(stress_with(project, 16) - one);
    EXPECT_GT(error, 1e-6 * one);
    const double estimate = 4.0 / 3.0 * std::abs(stress_with(project, 2) - one);
    EXPECT_GT(estimate, 0.5 * error);
    EXPECT_LT(estimate, 3.0 * error);
}

}  // namespace THIS_TEST
}  // namespace fretwork::design::detail
