// SPDX-License-Identifier: GPL-3.0-or-later
#include "sample.hpp"
#include "verification/benchmark_frames.hpp"

#include <fretwork/mechanics/nonlinear/lowest_mode.hpp>
#include <fretwork/mechanics/nonlinear/newton.hpp>

#include <gtest/gtest.h>

namespace fretwork::mechanics::nonlinear {
namespace THIS_TEST {

/// A structure, and a step from rest along its first rate.
struct Start {
    explicit Start(const Frame& frame)
        : assembly(assemble(frame)), system(assembly), newton(system, options) {
        system.evaluate(system.unknowns().rest(), 0.0);
        newton.factorize_at_rest();
        rate = newton.solve_tangent(system.load_rate());
    }
    [[nodiscard]] Configuration moved(const Eigen::VectorXd& step, double load_factor) const {
        Configuration configuration = system.unknowns().rest();
        system.unknowns().prescribe(load_factor, configuration);
        system.unknowns().move(step, configuration);
        return configuration;
    }
    EquilibriumOptions options;
    Assembly assembly;
    NonlinearSystem system;
    Newton newton;
    Eigen::VectorXd rate;
};

Frame pressed_strut(double force) {
    Frame frame = verification::thin_cantilever(6);
    frame.loads.push_back({NodeIndex(1), {-force, 0.0, 1e-4}});
    return frame;
}

TEST(Newton, FactorsAtTheEndCountTheEigenvaluesOfTheEquilibrium) {
    for (const Frame& frame : {sample::honeycomb(9, 6), pressed_strut(0.5), pressed_strut(3.0)}) {
        Start start(frame);
        for (const double load_factor : {0.02, 0.3, 1.0}) {
            const Eigen::VectorXd step = load_factor * start.rate;
            Configuration plain = start.moved(step, load_factor);
            if (start.newton.solve(load_factor, plain) != Termination::Converged) continue;
            const auto expected = start.newton.factorize();
            Configuration found = start.moved(step, load_factor);
            const auto outcome = start.newton.solve_and_factorize(load_factor, step, found);
            ASSERT_TRUE(outcome) << load_factor;
            EXPECT_EQ(outcome->negative_pivots, expected.negative_pivots) << load_factor;
            EXPECT_LE(start.system.relative_residual(), start.options.relative_residual);
            const Eigen::VectorXd between = start.system.unknowns().step_between(plain, found);
            EXPECT_LE(start.system.unknowns().largest_component(between), 1e-8) << load_factor;
        }
    }
}

// The factors at hand solve with the tangent of the equilibrium, up to the negligible part of the way.
TEST(Newton, FactorsAtTheEndAreThoseOfTheEquilibrium) {
    Start start(sample::honeycomb(9, 6));
    const double load_factor = 0.3;
    const Eigen::VectorXd step = load_factor * start.rate;
    Configuration found = start.moved(step, load_factor);
    ASSERT_TRUE(start.newton.solve_and_factorize(load_factor, step, found));
    const Eigen::VectorXd rate = start.newton.solve_tangent(start.system.load_rate());
    start.system.evaluate(found, load_factor);
    (void)start.newton.factorize();
    const Eigen::VectorXd expected = start.newton.solve_tangent(start.system.load_rate());
    const Unknowns& unknowns = start.system.unknowns();
    EXPECT_LT(unknowns.size_of(rate - expected), 0.01 * unknowns.size_of(expected));
}

TEST(Newton, WithoutAWayTheFactorsAreMadeAtTheEquilibrium) {
    Start start(sample::honeycomb(9, 6));
    Configuration rest = start.system.unknowns().rest();
    const auto outcome =
        start.newton.solve_and_factorize(0.0, Eigen::VectorXd::Zero(start.rate.size()), rest);
    ASSERT_TRUE(outcome);
    EXPECT_TRUE(outcome->positive_definite());
}

TEST(LowestMode, NamesNoNodeWhereNothingMoves) {
    const Assembly assembly = assemble(sample::star());
    const NonlinearSystem system(assembly);
    LowestMode none{0.0, Eigen::VectorXd::Zero(system.unknowns().equations())};
    const StabilityLoss loss = describe_loss(system, none, 0.5);
    EXPECT_FALSE(loss.node.is_valid());
    EXPECT_EQ(loss.load_factor, 0.5);
}

}  // namespace THIS_TEST
}  // namespace fretwork::mechanics::nonlinear
