// SPDX-License-Identifier: GPL-3.0-or-later
#include "sample.hpp"
#include "stops.hpp"
#include "verification/benchmark_frames.hpp"

#include <fretwork/base/error.hpp>
#include <fretwork/mechanics/paths/equilibrium_solver.hpp>

#include <gtest/gtest.h>

#include <numbers>

namespace fretwork::mechanics {
namespace THIS_TEST {

/// Bent to some share of its length, a partly held rotation and a prescribed displacement included.
Assembly bent_honeycomb() {
    Assembly assembly = assemble(sample::honeycomb(9, 6));
    assembly.loads *= 20.0;
    return assembly;
}

Solution from_rest(const Assembly& assembly) {
    constexpr double kFullLoad[] = {1.0};
    return follow_load_path(assembly, kFullLoad).back();
}

/// Residuals of 1e-9 of the loads leave so much of the displacements, and more of stiff beams' reactions.
void expect_equal(const Solution& found, const Solution& expected, const std::string& what) {
    ASSERT_TRUE(found.converged()) << what;
    EXPECT_LT((found.displacements - expected.displacements).norm(), 1e-7 * expected.displacements.norm())
        << what;
    EXPECT_LT((found.reactions - expected.reactions).norm(), 1e-6 * expected.reactions.norm()) << what;
    EXPECT_NEAR(found.energy, expected.energy, 1e-7 * expected.energy) << what;
    EXPECT_EQ(found.stable, expected.stable) << what;
    EXPECT_EQ(found.stability, expected.stability) << what;
}

/// One edit of some kind; the nodes stay.
std::string edit(Assembly& assembly, sample::Random& random) {
    const auto below = [&random](int count) {
        return std::min(static_cast<int>(0.5 * (random.next() + 1.0) * count), count - 1);
    };
    const int node = 18 + below(static_cast<int>(assembly.nodes.size()) - 18);
    switch (below(5)) {
        case 0:
            assembly.loads.row(node).head<3>() += 0.02 * random.vector(1.0).transpose();
            return "a force";
        case 1:
            assembly.loads.row(node).tail<3>() += 2e-5 * random.vector(1.0).transpose();
            return "a moment";
        case 2:
            assembly.prescribed[0].value += 1e-3 * random.next();
            return "a prescribed displacement";
        case 3: {
            Frame stiffer = sample::honeycomb(9, 6);
            const auto beam = static_cast<std::size_t>(below(static_cast<int>(stiffer.beams.size())));
            stiffer.beams[beam].section = rectangle_section(0.003, 0.003);
            assembly.elements[beam] = assemble(stiffer).elements[beam];
            return "an element";
        }
        default:
            if (assembly.supports.back().node == NodeIndex(30)) {
                assembly.supports.pop_back();
                return "a support removed";
            }
            assembly.supports.push_back({NodeIndex(30), DofSet::translations()});
            return "a support added";
    }
}

TEST(EquilibriumSolver, GivesTheAnswerFromRestAfterAnyEdits) {
    sample::Random random(31);
    Assembly assembly = bent_honeycomb();
    EquilibriumSolver solver;
    expect_equal(solver.solve(assembly), from_rest(assembly), "first");
    int from_last = 0;
    for (int i = 0; i < 40; ++i) {
        const std::string what = edit(assembly, random);
        const Solution found = solver.solve(assembly);
        from_last += solver.starting_point() == StartingPoint::LastEquilibrium;
        expect_equal(found, from_rest(assembly), what + ", " + std::to_string(i));
    }
    // Else the test would say nothing.
    EXPECT_GT(from_last, 25);
}

TEST(EquilibriumSolver, StartsFromTheLastEquilibriumWhereTheNodesAreTheSame) {
    Assembly assembly = bent_honeycomb();
    EquilibriumSolver solver;
    const Solution first = solver.solve(assembly);
    EXPECT_EQ(solver.starting_point(), StartingPoint::Rest);
    assembly.loads *= 1.1;
    const Solution second = solver.solve(assembly);
    EXPECT_EQ(solver.starting_point(), StartingPoint::LastEquilibrium);
    EXPECT_LT(second.iterations, first.iterations);
    const Assembly other = assemble(sample::honeycomb(9, 7));
    (void)solver.solve(other);
    EXPECT_EQ(solver.starting_point(), StartingPoint::Rest);
}

TEST(EquilibriumSolver, TellsItsFirstIterateWhereItGoesOnFromAnEquilibrium) {
    Assembly assembly = bent_honeycomb();
    EquilibriumSolver solver;
    std::vector<Solution> received;
    const auto tell = [&](const Solution& solution) { received.push_back(solution); };
    const Solution before = solver.solve(assembly, {}, StabilityCheck::Skipped, tell);
    EXPECT_TRUE(received.empty()) << "there is nothing to go on from";
    assembly.loads *= 1.02;
    const Solution after = solver.solve(assembly, {}, StabilityCheck::Skipped, tell);
    ASSERT_EQ(received.size(), 1U);
    EXPECT_FALSE(received.front().converged());
    EXPECT_TRUE(after.converged());
    // A tangent leaves an error that is quadratic in the move.
    EXPECT_LT((received.front().displacements - after.displacements).norm(),
              0.2 * (before.displacements - after.displacements).norm());
}

/// Before the factors are made anew on the way, and after it; for loads, and for an element, too.
TEST(EquilibriumSolver, GoesOnFromTheLastEquilibriumAfterAStopAtAnyLook) {
    const Assembly before = bent_honeycomb();
    Assembly loads = before;
    loads.loads *= 1.1;
    sample::Random random(5);
    Assembly element = before;
    while (edit(element, random) != "an element") element = before;
    for (const Assembly& after : {loads, element}) {
        const Solution expected = from_rest(after);
        EquilibriumSolver solver;
        test::expect_stops_at_any_look(
            [&](const base::Control& control) {
                (void)solver.solve(before);
                (void)solver.solve(after, control);
            },
            [&] {
                const Solution found = solver.solve(after);
                EXPECT_EQ(solver.starting_point(), StartingPoint::LastEquilibrium);
                expect_equal(found, expected, "after a stop");
            });
    }
}

/// Neither the lifted end nor its turn may move before the rest of the cantilever does.
TEST(EquilibriumSolver, FollowsPrescribedDisplacementsAndRotations) {
    Frame frame = verification::thin_cantilever(20);
    frame.prescribed = {{NodeIndex(1), Dof::uz, 0.2}, {NodeIndex(1), Dof::ry, -0.5}};
    Assembly assembly = assemble(frame);
    EquilibriumSolver solver;
    (void)solver.solve(assembly);
    for (const double more : {0.05, 0.1, -0.08}) {
        assembly.prescribed[0].value += more;
        assembly.prescribed[1].value -= more;
        const Solution found = solver.solve(assembly);
        EXPECT_EQ(solver.starting_point(), StartingPoint::LastEquilibrium) << more;
        expect_equal(found, from_rest(assembly), std::to_string(more));
    }
}

/// A shaft of one element: its path from rest ends where it is twisted by half a turn, and so does this one.
TEST(EquilibriumSolver, DoesNotTakeALargeTurnOfAHeldNodeForOneInTheOppositeSense) {
    constexpr double kTorquePerRadian = 0.5 * 1e9 * 2.5e-6;
    Frame frame = sample::cantilever();
    frame.supports.push_back({NodeIndex(1), {{false, true, true, false, true, true}}});
    frame.prescribed.push_back({NodeIndex(1), Dof::rx, 0.5});
    for (const double angle : {2.0, 3.5, 0.5 + 2.0 * std::numbers::pi}) {
        Assembly assembly = assemble(frame);
        EquilibriumSolver solver;
        ASSERT_TRUE(solver.solve(assembly).converged());
        assembly.prescribed[0].value = angle;
        const Solution found = solver.solve(assembly);
        EXPECT_EQ(found.converged(), angle < std::numbers::pi) << angle;
        EXPECT_NEAR(found.reactions(1, 3), kTorquePerRadian * angle * found.load_factor,
                    1e-6 * kTorquePerRadian)
            << angle;
    }
}

TEST(EquilibriumSolver, SolvesTheSameAssemblyAgainWithoutAStep) {
    const Assembly assembly = bent_honeycomb();
    EquilibriumSolver solver;
    const Solution first = solver.solve(assembly);
    const Solution again = solver.solve(assembly);
    EXPECT_EQ(again.iterations, 0);
    EXPECT_EQ((again.displacements - first.displacements).norm(), 0.0);
}

TEST(EquilibriumSolver, DoesNotGoOnFromAnUnstableEquilibrium) {
    Frame frame = verification::thin_cantilever(4);
    frame.loads.push_back({NodeIndex(1), {-3.0, 0.0, 0.0}});  // beyond Euler's load
    Assembly assembly = assemble(frame);
    EquilibriumSolver solver;
    EXPECT_FALSE(solver.solve(assembly).stable);
    assembly.loads *= 0.5;
    EXPECT_TRUE(solver.solve(assembly).stable);
    EXPECT_EQ(solver.starting_point(), StartingPoint::Rest);
}

/// Up to the limit load it goes on; beyond it the next equilibrium hangs, and no path leads there.
TEST(EquilibriumSolver, TellsALimitLoadLikeThePathFromRest) {
    Assembly toggle = assemble(verification::williams_toggle());
    const NodeValues loads = toggle.loads;
    EquilibriumSolver solver;
    for (const double factor : {0.5, 0.7, 0.9, 0.99, 1.05, 1.5, 3.0}) {
        toggle.loads = factor * loads;
        EXPECT_EQ(solver.solve(toggle).converged(), factor < 1.0) << factor;
    }
}

/// A path along which buckling is looked for begins at rest, also after derivatives were taken; the next
/// derivatives belong to the next assembly.
TEST(EquilibriumSolver, TakesDerivativesOfTheLastAssemblyAlongEveryBranch) {
    for (const Branch branch : {Branch::Stable, Branch::Snapping}) {
        EquilibriumSolver solver({.branch = branch});
        EquilibriumSolver primary;
        sample::Random random(3);
        Assembly assembly = bent_honeycomb();
        const Eigen::MatrixXd force = Eigen::MatrixXd::Ones(6 * std::ssize(assembly.nodes), 1);
        for (int i = 0; i < 5; ++i) {
            const std::string what = edit(assembly, random);
            expect_equal(solver.solve(assembly), primary.solve(assembly), what);
            EXPECT_EQ(solver.starting_point(), StartingPoint::Rest) << what;
            const Eigen::MatrixXd expected = primary.tangent().motions(force);
            EXPECT_LT((solver.tangent().motions(force) - expected).norm(), 1e-6 * expected.norm()) << what;
        }
    }
}

TEST(EquilibriumSolver, RefusesAMechanismAndGoesOnWhenItIsHeldAgain) {
    Assembly assembly = bent_honeycomb();
    EquilibriumSolver solver;
    const Solution held = solver.solve(assembly);
    Assembly loose = assembly;
    loose.supports.clear();
    loose.prescribed.clear();
    EXPECT_THROW((void)solver.solve(loose), base::NumericalError);
    expect_equal(solver.solve(assembly), held, "held again");
}

TEST(EquilibriumSolver, GivesTheSameBitsWithAnyNumberOfThreads) {
    const auto solve_with = [](int threads) {
        Assembly assembly = assemble(sample::honeycomb(60, 30));
        EquilibriumSolver solver({.threads = threads});
        (void)solver.solve(assembly);
        assembly.loads *= 1.3;
        return solver.solve(assembly).displacements;
    };
    EXPECT_EQ((solve_with(1) - solve_with(3)).norm(), 0.0);
}

TEST(EquilibriumSolver, DraggedLoadIsAnsweredWithoutStabilityAndSettlesWithIt) {
    Assembly assembly = bent_honeycomb();
    EquilibriumSolver solver;
    (void)solver.solve(assembly);
    for (const double factor : {1.05, 1.1, 1.15}) {
        assembly.loads = factor * bent_honeycomb().loads;
        const Solution dragged = solver.solve(assembly, {}, StabilityCheck::Skipped);
        Solution expected = from_rest(assembly);
        EXPECT_EQ(solver.starting_point(), StartingPoint::LastEquilibrium);
        EXPECT_EQ(dragged.stability, StabilityTest::None);
        expected.stability = StabilityTest::None;
        expect_equal(dragged, expected, std::to_string(factor));
    }
    expect_equal(solver.solve(assembly), from_rest(assembly), "settled");
    EXPECT_EQ(solver.starting_point(), StartingPoint::LastEquilibrium);
}

// It costs no more than from nothing: no way from the last equilibrium is tried.
TEST(EquilibriumSolver, NodeHeldFarFromWhereItIsIsAnsweredFromRestAtOnce) {
    Assembly assembly = bent_honeycomb();
    assembly.loads *= 12.0;
    EquilibriumSolver solver;
    const Solution free = solver.solve(assembly);
    Eigen::Index farthest = 0;
    const double moved = free.displacements.leftCols<3>().rowwise().norm().maxCoeff(&farthest);
    ASSERT_GT(moved, 0.02) << "two beams' lengths";
    assembly.supports.push_back({NodeIndex(farthest), DofSet::translations()});
    const Solution held = solver.solve(assembly);
    EXPECT_EQ(solver.starting_point(), StartingPoint::Rest);
    EquilibriumSolver fresh;
    const Solution expected = fresh.solve(assembly);
    EXPECT_EQ(held.iterations, expected.iterations);
    EXPECT_TRUE(held.displacements == expected.displacements);
    // Where it is held at the place where it is, there is nothing to wait for.
    assembly.supports.pop_back();
    (void)solver.solve(assembly);
    for (int d = 0; d < 3; ++d)
        assembly.prescribed.push_back(
            {NodeIndex(farthest), static_cast<Dof>(d), free.displacements(farthest, d)});
    (void)solver.solve(assembly);
    EXPECT_EQ(solver.starting_point(), StartingPoint::LastEquilibrium);
}

// The equations of the last assembly are taken up again; nothing of what they were used for shows.
TEST(EquilibriumSolver, FromRestAgainGivesTheBitsOfAFreshSolver) {
    Assembly assembly = bent_honeycomb();
    EquilibriumSolver solver;
    (void)solver.solve(assembly);
    for (const double factor : {-1.0, 0.7}) {  // to the other side: too far to go on
        assembly.loads = factor * bent_honeycomb().loads;
        const Solution again = solver.solve(assembly);
        if (solver.starting_point() == StartingPoint::LastEquilibrium) continue;
        EquilibriumSolver fresh;
        const Solution expected = fresh.solve(assembly);
        EXPECT_TRUE(again.displacements == expected.displacements) << factor;
        EXPECT_EQ(again.iterations, expected.iterations) << factor;
    }
}

/// A strut that is pressed exactly along its axis stays straight, whatever its stability.
TEST(EquilibriumSolver, StabilityThatIsLostWhileDraggingIsToldOnceItIsAskedFor) {
    Frame strut = verification::thin_cantilever(4);
    strut.loads.push_back({NodeIndex(1), {-1.5, 0.0, 0.0}});
    Assembly assembly = assemble(strut);
    EquilibriumSolver solver;
    EXPECT_TRUE(solver.solve(assembly).stable);
    assembly.loads *= 2.0;  // beyond Euler's load
    EXPECT_EQ(solver.solve(assembly, {}, StabilityCheck::Skipped).stability, StabilityTest::None);
    const Solution checked = solver.solve(assembly);
    EXPECT_EQ(checked.stability, StabilityTest::Tangent);
    EXPECT_FALSE(checked.stable);
}

}  // namespace THIS_TEST
}  // namespace fretwork::mechanics
