// SPDX-License-Identifier: GPL-3.0-or-later
#include "trials_of.hpp"

#include <fretwork/design/swaps/pair_table.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace fretwork::design::detail {
namespace THIS_TEST {

using Eigen::Index;
using Eigen::VectorXd;

const std::vector<std::size_t> kColumns = {0, 1, 2, 3, 4};

PairTable pairs_at(Trials& trials, const Point& point) {
    return trials.pair_table(point, trials.solve(point, {}), kColumns, 1, {});
}

VectorXd residual_of(const PairTable& table, const std::vector<std::size_t>& columns) {
    VectorXd residual = table.swaps.residual;
    for (std::size_t h = 0; h < columns.size(); ++h) {
        residual += table.swaps.responses[h].col(static_cast<Index>(columns[h]));
        for (std::size_t g = 0; g < h; ++g)
            residual += table.crosses[pair_place(g, h)].col(static_cast<Index>(columns[g] + 5 * columns[h]));
    }
    return residual;
}

/// So little load that the surface is linear: then the answer to two swaps is exact, however large they are.
TEST(PairTable, PredictsTwoSwapsExactlyWhereTheSurfaceIsLinear) {
    const simulation::Project project = test::cantilever_project(4, 2, 1e-7);
    Trials trials = test::trials_of(project, test::bent(1e-5));
    const Point point = test::random_painting(trials, 5);
    const double objective = trials.solve(point, {}).objective;
    const PairTable table = pairs_at(trials, point);
    base::SplitMix64 random(8);
    double superposed = 0.0;
    for (int i = 0; i < 15; ++i) {
        Point swapped = point;
        for (int swap = 0; swap < 2; ++swap)
            swapped.patterns[random.below(point.patterns.size())] = random.below(kColumns.size());
        const Trial found = trials.solve(swapped, {});
        ASSERT_TRUE(found.is_found);
        const double predicted = table.swaps.unreached + residual_of(table, swapped.patterns).squaredNorm();
        EXPECT_NEAR(predicted, found.objective, 2e-5 * objective) << i;
        VectorXd without = table.swaps.residual;
        for (std::size_t g = 0; g < swapped.patterns.size(); ++g)
            without += table.swaps.responses[g].col(static_cast<Index>(swapped.patterns[g]));
        superposed = std::max(superposed, std::abs(without.squaredNorm() - found.objective));
    }
    EXPECT_GT(superposed, 1e-3 * objective) << "without the crosses it is not exact";
}

/// Of groups of one tile, joint answers are those of the single tiles.
TEST(PairTable, HasTheSingleSwapsOfTheTable) {
    const simulation::Project project = test::cantilever_project(3, 2, 0.05);
    Trials trials = test::trials_of(project, test::bent(1.0));
    const Point point = test::random_painting(trials, 4);
    const Trial trial = trials.solve(point, {});
    const SwapTable single = trials.table(point, trial, kColumns, 1, {});
    const SwapTable joint = trials.pair_table(point, trial, kColumns, 1, {}).swaps;
    EXPECT_EQ(joint.masses, single.masses);
    EXPECT_LT((joint.energies - single.energies).norm(), 1e-9 * single.energies.norm());
    for (std::size_t g = 0; g < single.groups(); ++g)
        EXPECT_LT((joint.responses[g] - single.responses[g]).norm(), 1e-9 * single.responses[g].norm()) << g;
}

/// A choice that changes nothing is the point of the table.
TEST(PairTable, HasTheResidualsOfItsPoint) {
    const simulation::Project project = test::cantilever_project(3, 2, 0.05);
    Trials trials = test::trials_of(project, test::bent(1.0));
    const Point point = test::random_painting(trials, 2);
    const double objective = trials.solve(point, {}).objective;
    const PairTable table = pairs_at(trials, point);
    EXPECT_NEAR(table.swaps.unreached + residual_of(table, point.patterns).squaredNorm(), objective,
                1e-12 * objective);
}

/// Against each of the 5^5 choices, one by one; with a free factor against its best step in closed form.
TEST(PairTable, RanksAllChoices) {
    const simulation::Project project = test::cantilever_project(5, 1, 0.05);
    for (const FreeUnknowns& free : {FreeUnknowns{}, FreeUnknowns{.factor = true}}) {
        Trials trials = test::trials_of(project, test::bent(1.0), free);
        PairTable table = pairs_at(trials, test::random_painting(trials, 3));
        table.swaps.largest_steps.setConstant(1e6);
        std::vector<std::pair<double, std::vector<std::size_t>>> all;
        for (std::size_t number = 0; number < 3125; ++number) {
            std::vector<std::size_t> columns;
            for (std::size_t g = 0, rest = number; g < 5; ++g, rest /= 5) columns.push_back(rest % 5);
            VectorXd residual = residual_of(table, columns);
            if (free.factor) {
                const VectorXd by_factor = table.swaps.by_unknowns.col(0);
                residual -= by_factor * (by_factor.dot(residual) / by_factor.squaredNorm());
            }
            all.emplace_back(table.swaps.unreached + residual.squaredNorm(), std::move(columns));
        }
        std::ranges::sort(all);
        const std::vector<Choice> best = best_of_all(table, 40, {});
        ASSERT_EQ(best.size(), 40U);
        for (std::size_t i = 0; i < best.size(); ++i) {
            EXPECT_NEAR(best[i].objective, all[i].first, 1e-9 * all[i].first) << i;
            EXPECT_EQ(best[i].columns, all[i].second) << i;
        }
    }
}

TEST(PairTable, CountsChoicesUpToALimit) {
    EXPECT_EQ(choice_count(7, 5, 1'000'000), 78125U);
    EXPECT_EQ(choice_count(6, 10, 1'000'000), 1'000'000U);
    EXPECT_EQ(choice_count(7, 10, 1'000'000), 1'000'001U);
    EXPECT_EQ(choice_count(500, 1824, 1'000'000), 1'000'001U);
    EXPECT_EQ(choice_count(500, 1, 10), 1U);
}

}  // namespace THIS_TEST
}  // namespace fretwork::design::detail
