// SPDX-License-Identifier: GPL-3.0-or-later
// Results do not depend on the number of threads: not by a bit.
#include "sample.hpp"
#include "stops.hpp"

#include <fretwork/mechanics/linear_solver.hpp>
#include <fretwork/mechanics/nonlinear/nonlinear_system.hpp>
#include <fretwork/mechanics/paths/equilibrium.hpp>
#include <fretwork/mechanics/sparse/ldlt.hpp>

#include <gtest/gtest.h>

namespace fretwork::mechanics {
namespace THIS_TEST {

/// Some 4,500 beams: enough for threads to start, in all of their places.
const Frame& large_frame() {
    static const Frame frame = sample::honeycomb(60, 50);
    return frame;
}

bool same_bits(const Solution& a, const Solution& b) {
    return a.displacements == b.displacements && a.reactions == b.reactions && a.energy == b.energy &&
           a.residual == b.residual && a.iterations == b.iterations && a.stable == b.stable;
}

TEST(Threads, SampleIsLargeEnoughToUseThreads) {
    const Assembly assembly = assemble(large_frame());
    const nonlinear::NonlinearSystem system(assembly);
    const sparse::SupernodeTree tree = sparse::supernode_tree(system.unknowns().layout());
    EXPECT_GT(assembly.elements.size(), 4000U);
    EXPECT_EQ(sparse::plan_elimination(tree, 1).parent.size(), 1U);
    EXPECT_GT(sparse::plan_elimination(tree, 2).parent.size(), 4U);
}

TEST(Threads, PlanHoldsEverySupernodeOnceAndAfterItsChildren) {
    const Assembly assembly = assemble(large_frame());
    const nonlinear::NonlinearSystem system(assembly);
    const sparse::SupernodeTree tree = sparse::supernode_tree(system.unknowns().layout());
    for (const int threads : {1, 2, 4}) {
        const sparse::EliminationPlan plan = sparse::plan_elimination(tree, threads);
        std::vector<int> task_of(tree.supernodes.size(), -1);
        for (std::size_t task = 0; task < plan.parent.size(); ++task) {
            for (const int s : plan.supernodes_of(task)) {
                EXPECT_EQ(task_of[static_cast<std::size_t>(s)], -1);
                task_of[static_cast<std::size_t>(s)] = static_cast<int>(task);
            }
        }
        for (std::size_t s = 0; s < tree.supernodes.size(); ++s) {
            ASSERT_GE(task_of[s], 0);
            if (tree.supernodes[s].parent < 0) continue;
            const int above = task_of[static_cast<std::size_t>(tree.supernodes[s].parent)];
            if (above == task_of[s]) continue;
            EXPECT_EQ(plan.parent[static_cast<std::size_t>(task_of[s])], above);
            EXPECT_GT(above, task_of[s]);
        }
    }
}

TEST(Threads, AllEndWhenAFactorizationIsStopped) {
    const Assembly assembly = assemble(large_frame());
    nonlinear::NonlinearSystem system(assembly);
    system.evaluate(system.unknowns().rest(), 0.0);
    for (const int threads : {1, 4}) {
        sparse::Ldlt factors(system.unknowns().layout(), threads);
        const auto solution = [&] {
            EXPECT_TRUE(factors.factorize(system.tangent()).positive_definite());
            Eigen::VectorXd x = Eigen::VectorXd::Ones(factors.equations());
            factors.solve(x);
            return x;
        };
        const Eigen::VectorXd expected = solution();
        test::expect_stops_at_any_look(
            [&](const base::Control& control) { (void)factors.factorize(system.tangent(), control); }, [] {});
        EXPECT_TRUE(solution() == expected);
    }
}

TEST(Threads, ChangeNoBitOfALinearSolution) {
    const Assembly assembly = assemble(large_frame());
    const Solution one = solve_linear(assembly);
    EXPECT_GT(one.displacements.cwiseAbs().maxCoeff(), 0.0);
    for (const int threads : {2, 4})
        EXPECT_TRUE(same_bits(solve_linear(assembly, {.threads = threads}), one)) << threads;
}

TEST(Threads, ChangeNoBitOfANonlinearPath) {
    const Assembly assembly = assemble(large_frame());
    const double factors[] = {0.5, 1.0};
    const auto one = follow_load_path(assembly, factors);
    EXPECT_TRUE(one.back().converged());
    for (const int threads : {2, 4}) {
        const auto path = follow_load_path(assembly, factors, {.threads = threads});
        for (std::size_t i = 0; i < path.size(); ++i) EXPECT_TRUE(same_bits(path[i], one[i])) << threads;
    }
}

TEST(Threads, FindTheSameVanishingPivot) {
    const Assembly assembly = assemble(large_frame());
    nonlinear::NonlinearSystem system(assembly);
    system.evaluate(system.unknowns().rest(), 0.0);
    std::vector<double> values(system.tangent().begin(), system.tangent().end());
    // Uncouple some equations and leave them without stiffness, far apart and negative ones among the rest.
    const auto& start = system.unknowns().layout().column_start();
    for (const int equation : {9000, 12000, 15000}) {
        for (int column = 0; column <= equation; ++column) {
            for (auto k = start[static_cast<std::size_t>(column)];
                 k < start[static_cast<std::size_t>(column) + 1]; ++k) {
                if (column == equation ||
                    system.unknowns().layout().row()[static_cast<std::size_t>(k)] == equation)
                    values[static_cast<std::size_t>(k)] = 0.0;
            }
        }
    }
    for (std::size_t column = 0; column < 8000; column += 100)
        values[static_cast<std::size_t>(start[column])] *= -1.0;
    const auto one = sparse::Ldlt(system.unknowns().layout()).factorize(values);
    EXPECT_EQ(one.zero_pivot, 9000);
    EXPECT_GT(one.negative_pivots, 0);
    for (const int threads : {2, 4}) {
        const auto found = sparse::Ldlt(system.unknowns().layout(), threads).factorize(values);
        EXPECT_EQ(found.zero_pivot, one.zero_pivot);
        EXPECT_EQ(found.negative_pivots, one.negative_pivots);
    }
}

}  // namespace THIS_TEST
}  // namespace fretwork::mechanics
