// SPDX-License-Identifier: GPL-3.0-or-later
#include "trials_of.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace fretwork::design::detail {
namespace THIS_TEST {

const std::vector<std::size_t> kColumns = {0, 1, 2, 3, 4};

TEST(Trials, KnowThePointOfTheirLastSolution) {
    const simulation::Project project = test::cantilever_project(3, 2, 0.05);
    Trials trials = test::trials_of(project, test::bent(1.0), {.factor = true});
    const Point point = test::random_painting(trials, 1);
    Point other = point;
    other.unknowns[0] = 0.9;
    EXPECT_FALSE(trials.is_at(point));
    const Trial trial = trials.solve(point, {});
    EXPECT_TRUE(trials.is_at(point));
    EXPECT_FALSE(trials.is_at(other));
    EXPECT_DOUBLE_EQ(trials.objective_of(trial.displacements), trial.objective);
    (void)trials.solve(other, {});
    EXPECT_FALSE(trials.is_at(point));
}

/// So little load that the surface is linear: then the answer to one swap is exact, however large.
TEST(Swaps, PredictTheObjectiveOfASingleSwapExactlyWhereTheSurfaceIsLinear) {
    const simulation::Project project = test::cantilever_project(4, 3, 1e-7);
    Trials trials = test::trials_of(project, test::bent(1e-5));
    const Point point = test::random_painting(trials, 5);
    const Trial trial = trials.solve(point, {});
    ASSERT_TRUE(trial.is_found);
    const SwapTable table = trials.table(point, trial, kColumns, 1, {});
    EXPECT_NEAR(table.unreached + table.residual.squaredNorm(), trial.objective, 1e-9 * trial.objective);
    base::SplitMix64 random(8);
    for (int i = 0; i < 15; ++i) {
        const std::size_t group = random.below(point.patterns.size());
        const std::size_t column = random.below(kColumns.size());
        const Eigen::VectorXd residual =
            table.residual + table.responses[group].col(static_cast<Eigen::Index>(column));
        Point swapped = point;
        swapped.patterns[group] = column;
        const Trial found = trials.solve(swapped, {});
        ASSERT_TRUE(found.is_found);
        EXPECT_NEAR(table.unreached + residual.squaredNorm(), found.objective, 1e-5 * trial.objective)
            << "tile " << group << ", pattern " << column;
    }
}

/// Bent: the answers are those of the linearized surface, so that the error falls with the square of the
/// swap. A small swap is not at hand; its place take the unknowns, and the first order of the patterns is
/// tested by Sensitivity.
TEST(Swaps, UnknownsHaveTheDerivativesOfTheResiduals) {
    simulation::Project project = test::cantilever_project(4, 3, 0.05);
    project.load_cases.front().prescribed.push_back(
        {simulation::NodesAtSide{simulation::Side::Top}, mechanics::Dof::uz, 0.004});
    project.load_cases.front().gravity = {0.0, 0.0, -9.0};
    Trials trials = test::trials_of(project, test::bent(1.0), {true, true});
    Point point = test::random_painting(trials, 6);
    ASSERT_EQ(point.unknowns.size(), 2);
    const Trial trial = trials.solve(point, {});
    const SwapTable table = trials.table(point, trial, kColumns, 1, {});
    test::expect_derivatives(trials, point, table, Eigen::Vector2d(1e-4, 1e-6));
}

/// Exhaustively: the sweeps find the best of 5^5 choices of a superposition, from any start.
TEST(Swaps, SweepsFindTheBestChoiceOfSmallTables) {
    const simulation::Project project = test::cantilever_project(5, 1, 1e-7);
    Trials trials = test::trials_of(project, test::bent(2e-6));
    int found_best = 0;
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
        const Point point = test::random_painting(trials, seed);
        const Trial trial = trials.solve(point, {});
        const SwapTable table = trials.table(point, trial, kColumns, 1, {});
        double best = std::numeric_limits<double>::infinity();
        for (int number = 0; number < 3125; ++number) {
            Eigen::VectorXd residual = table.residual;
            for (int g = 0, rest = number; g < 5; ++g, rest /= 5)
                residual += table.responses[static_cast<std::size_t>(g)].col(rest % 5);
            best = std::min(best, residual.squaredNorm());
        }
        const Choice choice =
            sweep(table, point.patterns,
                  {.allowed = std::vector<bool>(5, true), .radius = 1e9, .seed = seed, .orders = 8});
        EXPECT_GE(choice.objective - table.unreached, best * (1.0 - 1e-9));
        found_best += choice.objective - table.unreached <= best * 1.001;
    }
    EXPECT_EQ(found_best, 10) << "of 10";
}

/// The residual norm of a choice, from the table alone.
double objective_of(const SwapTable& table, const Choice& choice) {
    Eigen::VectorXd residual = table.residual;
    for (std::size_t g = 0; g < choice.columns.size(); ++g)
        residual += table.responses[g].col(static_cast<Eigen::Index>(choice.columns[g]));
    if (choice.steps.size() > 0) residual += table.by_unknowns * choice.steps;
    return table.unreached + residual.squaredNorm();
}

TEST(Swaps, AnnealingIsNoWorseThanSweepsAndStaysWithinTheRadius) {
    const simulation::Project project = test::cantilever_project(6, 4, 0.05);
    int better = 0;
    for (const FreeUnknowns& free : {FreeUnknowns{}, FreeUnknowns{.factor = true}}) {
        Trials trials = test::trials_of(project, test::bent(2.0), free);
        const Point point = test::random_painting(trials, 7);
        const SwapTable table = trials.table(point, trials.solve(point, {}), kColumns, 1, {});
        for (const double radius : {0.02, 0.2, 4.0}) {
            SweepOptions options{.allowed = std::vector<bool>(5, true), .radius = radius, .proposals = 0};
            const Choice swept = sweep(table, point.patterns, options);
            options.proposals = 1000;
            const Choice annealed = sweep(table, point.patterns, options);
            EXPECT_LE(annealed.energy, radius * table.energy);
            EXPECT_LE(annealed.objective, swept.objective);
            EXPECT_NEAR(annealed.objective, objective_of(table, annealed), 1e-9 * swept.objective);
            better += annealed.objective < 0.999 * swept.objective;
        }
    }
    EXPECT_GE(better, 1) << "of 6: otherwise it is worth nothing";
}

/// Against every choice that differs in one or two places.
TEST(Swaps, NeighboursAreTheBestOfAllThatDifferInOneOrTwoPlaces) {
    const simulation::Project project = test::cantilever_project(5, 1, 0.05);
    Trials trials = test::trials_of(project, test::bent(2.0));
    const Point point = test::random_painting(trials, 4);
    const SwapTable table = trials.table(point, trials.solve(point, {}), kColumns, 1, {});
    std::vector<std::vector<double>> objectives(6);
    for (int number = 0; number < 3125; ++number) {
        Choice choice{point.patterns, Eigen::VectorXd()};
        std::size_t changes = 0;
        for (std::size_t g = 0, rest = static_cast<std::size_t>(number); g < 5; ++g, rest /= 5) {
            choice.columns[g] = rest % 5;
            changes += choice.columns[g] != point.patterns[g];
        }
        objectives[changes].push_back(objective_of(table, choice));
    }
    for (auto& own : objectives) std::ranges::sort(own);
    ASSERT_EQ(objectives[1].size(), 20U);
    ASSERT_EQ(objectives[2].size(), 160U);
    const auto found = neighbours(table, point.patterns, std::vector<bool>(5, true), 30, {});
    ASSERT_EQ(found.size(), 50U);
    for (std::size_t i = 0; i < found.size(); ++i)
        EXPECT_NEAR(found[i].objective, i < 20 ? objectives[1][i] : objectives[2][i - 20],
                    1e-12 * objectives[2].back());
    for (const Choice& choice : neighbours(table, point.patterns, {true, false, true, false, true}, 30, {})) {
        for (std::size_t g = 0; g < 5; ++g)
            EXPECT_TRUE(choice.columns[g] % 2 == 0 || choice.columns[g] == point.patterns[g]);
    }
}

TEST(Swaps, KeepTheRadiusTheMassAndTheColumns) {
    const simulation::Project project = test::cantilever_project(5, 4, 0.05);
    Trials trials = test::trials_of(project, test::bent(2.0));
    const Point point = test::random_painting(trials, 3);
    const Trial trial = trials.solve(point, {});
    const SwapTable table = trials.table(point, trial, kColumns, 1, {});
    SweepOptions options{.allowed = {true, true, false, true, false}, .radius = 0.05};
    options.allowed = std::vector<bool>(5, true);
    const Choice near = sweep(table, point.patterns, options);
    EXPECT_LE(near.energy, 0.05 * table.energy);
    EXPECT_LT(near.objective, trial.objective);
    const auto mass = [&](const Choice& choice) {
        double sum = 0.0;
        for (std::size_t g = 0; g < choice.columns.size(); ++g)
            sum += table.masses(static_cast<Eigen::Index>(choice.columns[g]), static_cast<Eigen::Index>(g));
        return sum;
    };
    options.radius = 10.0;
    const double free_mass = mass(sweep(table, point.patterns, options));
    options.most_mass = 0.9 * free_mass;
    EXPECT_LE(mass(sweep(table, point.patterns, options)), 0.9 * free_mass);
    options.most_mass = 0.0;
    const auto allowed = fewer_columns(table, point.patterns, options, 2);
    EXPECT_EQ(std::ranges::count(allowed, true), 2);
    options.allowed = allowed;
    for (const std::size_t column : sweep(table, point.patterns, options).columns)
        EXPECT_TRUE(allowed[column]);
}

}  // namespace THIS_TEST
}  // namespace fretwork::design::detail
