// SPDX-License-Identifier: GPL-3.0-or-later
#include "hinged_cantilever.hpp"
#include "sample.hpp"
#include "verification/benchmark_frames.hpp"

#include <fretwork/base/error.hpp>
#include <fretwork/geometry/rotation.hpp>
#include <fretwork/mechanics/linear_solver.hpp>
#include <fretwork/mechanics/paths/equilibrium.hpp>
#include <fretwork/mechanics/paths/relaxation.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace fretwork::mechanics {
namespace THIS_TEST {

using Eigen::Vector3d;

constexpr double kPi = std::numbers::pi;

Solution full_load(const Frame& frame, int steps = 1) {
    std::vector<double> factors;
    for (int k = 1; k <= steps; ++k) factors.push_back(static_cast<double>(k) / steps);
    return follow_load_path(assemble(frame), factors).back();
}

using verification::thin_cantilever;

// Benchmark 1: u/L = sin t / t - 1, w/L = (1 - cos t) / t with t = M L / E I, exact; t = 2 pi closes the
// circle.
TEST(Equilibrium, EndMomentRollsCantileverIntoCircularArcs) {
    for (const double angle : {0.5, 1.0, 1.5, kPi, 2.0 * kPi, 4.0 * kPi}) {
        Frame frame = thin_cantilever(20);
        frame.loads.push_back({NodeIndex(1), Vector3d::Zero(), {0.0, -angle, 0.0}});
        const Solution solution = full_load(frame, 10);
        ASSERT_TRUE(solution.converged()) << angle;
        // The element reproduces constant curvature exactly; what is left is the residual's tolerance, 1e-9
        // of a moment over an element's length, on the whole length.
        EXPECT_NEAR(solution.displacements(1, 0), std::sin(angle) / angle - 1.0, 1e-6) << angle;
        EXPECT_NEAR(solution.displacements(1, 2), (1.0 - std::cos(angle)) / angle, 1e-6) << angle;
        EXPECT_NEAR(solution.displacements(1, 4), -angle, 1e-6) << angle;
        EXPECT_NEAR(solution.reactions(0, 4), angle, 1e-6);
    }
}

TEST(Equilibrium, RollUpIsIndependentOfOrientation) {
    Frame frame = thin_cantilever(20);
    const Eigen::Quaterniond turn = geometry::exponential({0.7, -0.4, 1.1});
    frame.nodes[1] = turn * frame.nodes[1];
    frame.loads.push_back({NodeIndex(1), Vector3d::Zero(), turn * Vector3d(0.0, -2.0 * kPi, 0.0)});
    const Solution solution = full_load(frame, 10);
    ASSERT_TRUE(solution.converged());
    const Vector3d moved = turn.conjugate() * Vector3d(solution.displacements.row(1).head<3>().transpose());
    EXPECT_LT((moved - Vector3d(-1.0, 0.0, 0.0)).norm(), 1e-7);
}

// Positions are known to 1e-16 of their size, and stiff beams make forces of that: a residual relative to
// such loads cannot be small, though the displacements are good.
TEST(Equilibrium, ApproachesLinearSolutionAsLoadVanishes) {
    Frame frame = sample::cantilever({.divisions = 8});
    frame.nodes[1] = {0.4, 0.3, -0.8};
    frame.loads.push_back({NodeIndex(1), {0.3, 1.0, -0.2}, {0.1, 0.2, 0.4}});
    const Solution linear = solve_linear(assemble(frame));
    for (double load = 1e-4; load > 1e-20; load *= 0.1) {
        frame.loads = {{NodeIndex(1), load * Vector3d(0.3, 1.0, -0.2), load * Vector3d(0.1, 0.2, 0.4)}};
        const Solution solution = full_load(frame);
        ASSERT_TRUE(solution.converged()) << load;
        // 1e-5: what the curvature of the path leaves at the largest load, and rounding at the smallest.
        EXPECT_LT((solution.displacements - load * linear.displacements).norm(),
                  1e-5 * load * linear.displacements.norm())
            << load;
    }
}

// Supports that move as one rigid body load a structure with nothing. All forces are rounding, which no
// residual relative to them can be small beside.
TEST(Equilibrium, FollowsSupportsThatMoveAsARigidBody) {
    Frame frame = sample::cantilever({.divisions = 8});
    frame.nodes[1] = {0.4, 0.3, -0.8};
    frame.loads.clear();
    frame.supports = {{NodeIndex(0), {{false, true, true, true, true, true}}}};
    frame.prescribed.push_back({NodeIndex(0), Dof::ux, 0.02});
    const Solution linear = solve_linear(assemble(frame));
    const Solution nonlinear = full_load(frame);
    for (const Solution& solution : {linear, nonlinear}) {
        ASSERT_TRUE(solution.converged());
        // Rounding of 0.02 m at nodes that are a metre away from the origin.
        for (Eigen::Index node = 0; node < solution.displacements.rows(); ++node)
            EXPECT_LT((solution.displacements.row(node).head<3>() - Eigen::RowVector3d(0.02, 0, 0)).norm(),
                      1e-13);
    }
}

// A stiff part must not raise the residual that is allowed in a soft part far from it.
TEST(Equilibrium, ResidualIsJudgedAtEachNode) {
    Frame frame = thin_cantilever(20);
    frame.loads.push_back({NodeIndex(1), {0.0, 0.0, 2.0}});
    frame.nodes.emplace_back(0.0, 5.0, 0.0);
    frame.nodes.emplace_back(0.0, 5.0, 0.01);
    frame.beams.push_back({.nodes = {NodeIndex(2), NodeIndex(3)},
                           .section = {.area = 10.0, .I2 = 10.0, .I3 = 10.0, .J = 10.0},
                           .material = {.young_modulus = 1e13, .poisson_ratio = 0.0}});
    frame.supports.push_back({NodeIndex(2), DofSet::all()});
    for (const int steps : {1, 10}) {
        const Solution solution = full_load(frame, steps);
        ASSERT_TRUE(solution.converged()) << steps;
        EXPECT_NEAR(solution.displacements(1, 2), .493457, 5e-6);  // as below
    }
    const Solution relaxed = relax(assemble(frame), {.iterations = 2000});
    EXPECT_FALSE(relaxed.converged());
}

// A shaft whose end is turned: G J / L times the angle, as long as each division turns by less than pi;
// beyond that the path ends, and does not go on with the angle less a whole turn.
TEST(Equilibrium, PathEndsWhereAnElementIsTwistedByHalfATurn) {
    const double torque_per_radian = 0.5 * 1e9 * 2.5e-6;
    for (const double angle : {3.0, 4.0, 7.0, 13.0}) {
        for (const int divisions : {1, 2, 4, 8}) {
            for (const int steps : {1, 10}) {
                Frame frame = sample::cantilever({.divisions = divisions});
                frame.supports.push_back({NodeIndex(1), {{false, true, true, false, true, true}}});
                frame.prescribed.push_back({NodeIndex(1), Dof::rx, angle});
                const Solution solution = full_load(frame, steps);
                EXPECT_EQ(solution.converged(), angle / divisions < kPi) << angle << " " << divisions;
                EXPECT_NEAR(solution.reactions(1, 3), torque_per_radian * angle * solution.load_factor,
                            1e-6 * torque_per_radian);
            }
        }
    }
}

// Benchmark 2: Mattiasson, Int. J. Num. Meth. Eng. 17 (1981), table of elliptic integrals; the other rows
// were computed by shooting. (w/L, u/L, tip angle) against P L^2 / E I.
TEST(Equilibrium, TipForceOnCantileverMatchesElastica) {
    struct Row {
        double load, w, u, angle;
    };
    for (const Row& row : {Row{0.25, .082746, .004118, .124292}, Row{1, .301721, .056433, .461352},
                           Row{2, .493457, .160642, .781750}, Row{5, .713792, .387628, 1.215368},
                           Row{10, .810609, .554996, 1.430286}}) {
        Frame frame = thin_cantilever(20);
        frame.loads.push_back({NodeIndex(1), {0.0, 0.0, row.load}});
        const Solution solution = full_load(frame, 5);
        ASSERT_TRUE(solution.converged());
        // Half a digit of the table and the discretization error of twenty elements.
        EXPECT_NEAR(solution.displacements(1, 2), row.w, 5e-6);
        EXPECT_NEAR(-solution.displacements(1, 0), row.u, 5e-6);
        EXPECT_NEAR(-solution.displacements(1, 4), row.angle, 5e-6);
        EXPECT_EQ(solution.stability, StabilityTest::Tangent);
        EXPECT_TRUE(solution.stable);
    }
}

// Benchmark 3: Bathe and Bolourchi, Int. J. Num. Meth. Eng. 14 (1979). Reference: the geometrically exact rod
// by shooting. Straight beams are a polygon in the arc: its error falls with the square of their number, and
// two polygons extrapolate to the arc.
TEST(Equilibrium, FortyFiveDegreeBendMatchesBatheAndBolourchi) {
    struct Row {
        double torsion_constant, factor;
        Vector3d tip;
    };
    for (const Row& row : {Row{1.0 / 6.0, 1.0, {-23.55853, -13.60397, 53.47176}},
                           Row{0.140577, 0.5, {-12.17363, -7.17620, 40.47778}},
                           Row{0.140577, 0.75, {-18.73950, -10.91948, 48.70199}},
                           Row{0.140577, 1.0, {-23.81706, -13.73099, 53.60428}}}) {
        std::vector<Vector3d> tips;
        for (const int beams : {16, 32}) {
            const double factors[] = {0.5 * row.factor, row.factor};
            const auto path = follow_load_path(
                assemble(verification::bathe_bolourchi_bend(beams, row.torsion_constant)), factors);
            ASSERT_TRUE(path.back().converged());
            tips.emplace_back(path.back().displacements.row(beams).head<3>().transpose());
        }
        const Vector3d arc = (4.0 * tips[1] - tips[0]) / 3.0;
        EXPECT_LT((arc - row.tip).norm(), 5e-4) << arc.transpose();
        EXPECT_LT((tips[1] - row.tip).norm(), 0.01) << tips[1].transpose();
    }
}

TEST(Equilibrium, SmallLoadsGiveTheLinearSolution) {
    for (Frame frame : {sample::star(), sample::flat_wheel()}) {
        if (frame.loads.empty())
            frame.loads.push_back({NodeIndex(4), {0.5, -0.3, 0.7}, {0.001, 0.002, 0.003}});
        for (NodalLoad& load : frame.loads) {
            load.force *= 1e-6;
            load.moment *= 1e-6;
        }
        const Solution linear = solve_linear(assemble(frame));
        const Solution nonlinear = full_load(frame);
        ASSERT_TRUE(nonlinear.converged());
        // The linear solution's own error is of the order of the rotations, 1e-6.
        EXPECT_LT((nonlinear.displacements - linear.displacements).norm(),
                  1e-5 * linear.displacements.norm());
    }
}

TEST(Equilibrium, RotatingStructureRotatesSolution) {
    Frame frame = sample::star();
    const Solution before = full_load(frame, 4);
    const Eigen::Quaterniond turn = geometry::exponential({0.7, -0.4, 1.1});
    for (Beam& beam : frame.beams) beam.normal = turn * Vector3d::UnitZ();
    for (Vector3d& node : frame.nodes) node = turn * node;
    frame.loads[0].force = turn * frame.loads[0].force;
    frame.loads[0].moment = turn * frame.loads[0].moment;
    const Solution after = full_load(frame, 4);
    for (Eigen::Index i = 0; i < 4; ++i) {
        for (const int part : {0, 3}) {
            const Vector3d expected =
                turn * Vector3d(before.displacements.row(i).segment<3>(part).transpose());
            const Vector3d found = after.displacements.row(i).segment<3>(part);
            EXPECT_LT((found - expected).norm(), 1e-8 * before.displacements.norm());
        }
    }
}

TEST(Equilibrium, ReactionsBalanceTheLoadsInTheDeformedShape) {
    Frame frame = sample::flat_wheel();
    frame.supports.push_back({NodeIndex(2), {{true, false, true, false, true, false}}});
    frame.loads.push_back({NodeIndex(4), {0.05, -0.3, 0.3}, {0.002, 0.003, -0.001}});
    frame.loads.push_back({NodeIndex(5), {0.05, 0.3, 0.3}});
    const Assembly assembly = assemble(frame);
    const double factors[] = {0.5, 1.0};
    const Solution solution = follow_load_path(assembly, factors).back();
    ASSERT_TRUE(solution.converged());
    Vector3d force = Vector3d::Zero();
    Vector3d moment = Vector3d::Zero();
    for (Eigen::Index i = 0; i < 12; ++i) {
        const Vector3d at = frame.nodes[i] + Vector3d(solution.displacements.row(i).head<3>().transpose());
        const Vector3d f = (assembly.loads.row(i) + solution.reactions.row(i)).head<3>().transpose();
        force += f;
        moment +=
            at.cross(f) + Vector3d((assembly.loads.row(i) + solution.reactions.row(i)).tail<3>().transpose());
    }
    EXPECT_LT(force.norm(), 1e-8 * 0.5);
    EXPECT_LT(moment.norm(), 1e-8 * 0.01);
}

// Simpson's rule on the rate of work: the stored energy is the work of the loads.
TEST(Equilibrium, EnergyIsTheWorkOfTheLoads) {
    Frame frame = sample::star();
    frame.loads[0] = {NodeIndex(0), {0.3, -0.2, 1.0}};
    std::vector<double> factors;
    for (int k = 1; k <= 40; ++k) factors.push_back(k / 40.0);
    const auto path = follow_load_path(assemble(frame), factors);
    const auto moved = [&](std::size_t k) {
        return k == 0 ? 0.0
                      : path[k - 1].displacements.row(0).head<3>().dot(frame.loads[0].force.transpose());
    };
    double complementary = 0.0;  // integral of displacement over load
    for (std::size_t k = 0; k < 40; k += 2)
        complementary += (moved(k) + 4.0 * moved(k + 1) + moved(k + 2)) / 120.0;
    const double work = moved(40) - complementary;
    EXPECT_NEAR(path.back().energy, work, 1e-6 * work);
}

TEST(Equilibrium, LoadStepsDoNotChangeTheEnd) {
    const Frame frame = sample::star();
    const Solution one = full_load(frame, 1);
    const Solution many = full_load(frame, 9);
    EXPECT_LT((one.displacements - many.displacements).norm(), 1e-7 * one.displacements.norm());
    EXPECT_LE(one.residual, 1e-9);
    EXPECT_LE(many.residual, 1e-9);
}

// Held against twist, pulled by a force: the free components of the total rotation vector are the unknowns.
TEST(Equilibrium, HeldRotationComponentStaysZeroAtLargeRotations) {
    Frame frame =
        sample::cantilever({.divisions = 8, .section = {.area = 0.01, .I2 = 1e-6, .I3 = 2e-6, .J = 1e-6}});
    frame.supports.push_back({NodeIndex(1), {{false, false, false, true, false, false}}});
    frame.loads.push_back({NodeIndex(1), {0.0, 3000.0, 2000.0}});
    const Solution solution = full_load(frame, 8);
    ASSERT_TRUE(solution.converged());
    EXPECT_EQ(solution.displacements(1, 3), 0.0);
    EXPECT_GT(solution.displacements.row(1).tail<3>().norm(), 0.9);
    EXPECT_NE(solution.reactions(1, 3), 0.0);
}

TEST(Equilibrium, PrescribedEndRotationGivesRollUpMoment) {
    Frame frame = thin_cantilever(16);
    frame.prescribed.push_back({NodeIndex(1), Dof::ry, -1.5 * kPi});
    const Solution solution = full_load(frame, 10);
    ASSERT_TRUE(solution.converged());
    EXPECT_NEAR(solution.displacements(1, 0), std::sin(1.5 * kPi) / (1.5 * kPi) - 1.0, 1e-6);
    EXPECT_NEAR(solution.reactions(1, 4), -1.5 * kPi, 1e-6);
    EXPECT_NEAR(solution.displacements(1, 4), -1.5 * kPi, 1e-12);
}

TEST(Equilibrium, ReactionOfPrescribedDisplacementIsTheForceThatCausesIt) {
    Frame frame = thin_cantilever(10);
    frame.prescribed.push_back({NodeIndex(1), Dof::uz, .493457});
    const Solution solution = full_load(frame, 5);
    ASSERT_TRUE(solution.converged());
    EXPECT_NEAR(solution.reactions(1, 2), 2.0, 5e-5);
    EXPECT_NEAR(-solution.displacements(1, 0), .160642, 5e-6);
}

// A hinge in all three rotations hands over forces only; at large displacements the two halves are two
// elastica.
TEST(Equilibrium, HingesCarryNoMomentAtLargeRotations) {
    Frame frame = thin_cantilever(10);
    frame.nodes.emplace_back(2.0, 0.0, 0.0);
    frame.beams.push_back(frame.beams[0]);
    frame.beams[1].nodes = {NodeIndex(2), NodeIndex(1)};
    frame.beams[1].releases = {{1, {{false, false, false, true, true, true}}}};
    sample::clamp(frame, 2);
    frame.supports.back() = {NodeIndex(2), {{false, true, true, true, true, true}}};
    frame.loads.push_back({NodeIndex(1), {0.0, 0.0, 4.0}});
    const Solution solution = full_load(frame, 8);
    ASSERT_TRUE(solution.converged());
    // The right half slides freely along x, so each half carries half of the load as a cantilever.
    EXPECT_NEAR(solution.displacements(1, 2), .493457, 5e-5);
    EXPECT_NEAR(-solution.displacements(1, 0), .160642, 5e-5);
    EXPECT_NEAR(solution.displacements(2, 0), 2.0 * solution.displacements(1, 0), 1e-8);
    EXPECT_NEAR(-solution.displacements(1, 4), .781750, 5e-5);
}

// Euler: a clamped-free column buckles at pi^2 E I / (4 L^2); the straight state goes on, unstable.
TEST(Equilibrium, CompressedColumnIsUnstableBeyondEulerLoad) {
    Frame frame = thin_cantilever(4);
    frame.loads.push_back({NodeIndex(1), {-kPi * kPi / 4.0, 0.0, 0.0}});
    const double factors[] = {0.5, 0.99, 1.01, 2.0};
    const auto path = follow_load_path(assemble(frame), factors);
    const bool expected[] = {true, true, false, false};
    for (std::size_t k = 0; k < 4; ++k) {
        EXPECT_TRUE(path[k].converged());
        EXPECT_EQ(path[k].stable, expected[k]) << factors[k];
        EXPECT_EQ(path[k].stability, StabilityTest::Tangent);
    }
}

// A load that hardly moves the column decides about its stability.
TEST(Equilibrium, CompressedColumnIsUnstableHoweverLongTheStep) {
    for (const double load : {0.5, 0.99, 1.01, 2.0}) {
        Frame frame = thin_cantilever(4);
        frame.loads.push_back({NodeIndex(1), {-load * kPi * kPi / 4.0, 0.0, 0.0}});
        const Solution solution = full_load(frame);
        EXPECT_TRUE(solution.converged()) << load;
        EXPECT_EQ(solution.stable, load < 1.0) << load;
    }
}

TEST(Equilibrium, StabilityUnderFixedMomentsIsThatOfSymmetricPart) {
    const Solution solution = full_load(sample::star());
    EXPECT_EQ(solution.stability, StabilityTest::SymmetricPart);
    EXPECT_TRUE(solution.stable);
}

// Williams' toggle snaps by a few hundredths of a bar's length; the frame's load is its limit load. Far
// beyond it the load has another equilibrium, in which the toggle hangs: no path leads there.
TEST(Equilibrium, SnapOfShallowToggleIsDetectedForAnyStepLength) {
    const Assembly toggle = assemble(verification::williams_toggle());
    for (const double reach : {1.2, 3.0, 12.0}) {
        for (const int steps : {1, 2, 3, 5, 10, 50}) {
            std::vector<double> factors;
            for (const double factor : even_load_factors(steps)) factors.push_back(reach * factor);
            const auto path = follow_load_path(toggle, factors);
            EXPECT_EQ(path.back().termination, Termination::LimitLoad) << reach << ", " << steps;
            EXPECT_NEAR(path.back().load_factor, 1.0, 1e-4) << reach << ", " << steps;  // of the published
        }
    }
}

// The bars of this roof buckle in their plane before it snaps. A long first step once landed on the path
// beyond the limit load, where the buckled bars hold again, and followed it to 2.5 times the limit.
TEST(Equilibrium, LongStepDoesNotJumpPastLimitLoadAfterBifurcation) {
    Frame frame;
    frame.nodes = {{0, 0, 0}, {1, 0, 0.05}, {2, 0, 0}};
    for (const int from : {0, 2}) {
        Beam beam = sample::beam_between(from, 1);
        const double inertia = 1e-8 / 12.0;
        beam.section = {.area = 1e-4, .I2 = inertia, .I3 = inertia, .J = 1.69 * inertia};
        beam.divisions = 4;
        beam.releases = {{0, {{false, false, false, false, true, false}}}};
        frame.beams.push_back(beam);
    }
    sample::clamp(frame, 0);
    sample::clamp(frame, 2);
    frame.supports.push_back({NodeIndex(1), {{false, true, false, true, false, true}}});
    frame.loads.push_back({NodeIndex(1), {0.0, 0.0, -20.0}});
    const Assembly roof = assemble(frame);
    const double limit = follow_load_path(roof, even_load_factors(200)).back().load_factor;
    EXPECT_LT(limit, 0.1);
    for (const int steps : {1, 2, 3, 5, 10}) {
        const auto end = follow_load_path(roof, even_load_factors(steps)).back();
        EXPECT_EQ(end.termination, Termination::LimitLoad) << steps;
        EXPECT_NEAR(end.load_factor, limit, 1e-5 * limit) << steps;
    }
}

/// Twenty beams of a strip, 1 m long, that is pressed together, with a force at its middle.
Frame imperfect_column(double shortening, double share_of_euler) {
    constexpr int kBeams = 20;
    Frame frame;
    for (int i = 0; i <= kBeams; ++i) frame.nodes.emplace_back(i / static_cast<double>(kBeams), 0, 0);
    for (int i = 0; i < kBeams; ++i) {
        Beam beam = sample::beam_between(i, i + 1);
        beam.section = rectangle_section(0.02, 0.002);
        frame.beams.push_back(beam);
    }
    for (int i = 1; i < kBeams; ++i)
        frame.supports.push_back({NodeIndex(i), {{false, true, false, true, false, true}}});
    frame.supports.push_back({NodeIndex(0), {{true, true, true, true, false, true}}});
    frame.supports.push_back({NodeIndex(kBeams), {{false, true, true, true, true, true}}});
    frame.prescribed.push_back({NodeIndex(kBeams), Dof::ux, -shortening});
    const Beam& beam = frame.beams.front();
    const double euler = kPi * kPi * beam.material.young_modulus * beam.section.I2;
    frame.loads.push_back({NodeIndex(kBeams / 2), {0, 0, share_of_euler * euler}});
    return frame;
}

// Pressed far beyond the load at which the straight column buckles, the path stays smooth: it goes to the
// side of the force. 300 equal steps pass the bend in the path at 0.0006 of the wanted shortening step by
// step.
TEST(Equilibrium, ImperfectColumnBucklesToTheSideOfItsForceHoweverLongTheStep) {
    for (const double shortening : {0.001, 0.1}) {
        for (const double share : {0.001, 0.02}) {
            const Assembly column = assemble(imperfect_column(shortening, share));
            const Solution reference = follow_load_path(column, even_load_factors(300)).back();
            ASSERT_TRUE(reference.converged());
            EXPECT_GT(reference.displacements(10, 2), 0.0);
            for (const Branch branch : {Branch::Primary, Branch::Stable, Branch::Snapping}) {
                const Solution once = follow_load_path(column, std::vector{1.0}, {.branch = branch}).back();
                ASSERT_TRUE(once.converged()) << shortening << ", " << share;
                EXPECT_TRUE(once.stable);
                EXPECT_TRUE(once.stability_losses.empty());
                EXPECT_LT((once.displacements - reference.displacements).norm(),
                          1e-6 * reference.displacements.norm());
            }
        }
    }
}

// Von Mises' truss: with hinged bars of rest length l0 that rise by h, the load at the depth w of the apex is
// 2 E A (l0 - l) / l0 (h - w) / l; its largest value is the limit load.
TEST(Equilibrium, PathEndsAtLimitLoadAndReportsIt) {
    constexpr double kRise = 0.1;
    Frame frame;
    frame.nodes = {{-1, 0, 0}, {0, 0, kRise}, {1, 0, 0}};
    for (const auto& [from, to] : {std::pair{0, 1}, std::pair{2, 1}}) {
        frame.beams.push_back(sample::beam_between(from, to));
        frame.beams.back().section = {.area = 1e-4, .I2 = 1e-6, .I3 = 1e-6, .J = 1e-6};
        frame.beams.back().releases = {{0, {{false, false, false, true, true, true}}},
                                       {1, {{false, false, false, true, true, true}}}};
    }
    sample::clamp(frame, 0);
    sample::clamp(frame, 2);
    frame.supports.push_back({NodeIndex(1), {{true, true, false, true, true, true}}});
    const double rest_length = std::hypot(1.0, kRise);
    double limit = 0.0;
    for (double w = 0.0; w < kRise; w += 1e-6) {
        const double length = std::hypot(1.0, kRise - w);
        limit = std::max(limit, 2.0 * 1e5 * (rest_length - length) / rest_length * (kRise - w) / length);
    }
    frame.loads.push_back({NodeIndex(1), {0.0, 0.0, -limit}});
    const double factors[] = {0.5, 0.9, 0.9999, 1.1};
    const auto path = follow_load_path(assemble(frame), factors);
    for (std::size_t k = 0; k < 3; ++k) {
        EXPECT_TRUE(path[k].converged());
        EXPECT_TRUE(path[k].stable);
    }
    // Beyond, there is an equilibrium only where the truss has snapped through.
    EXPECT_EQ(path[3].termination, Termination::LimitLoad);
    EXPECT_NEAR(path[3].load_factor, 1.0, 2e-4);
    EXPECT_LE(path[3].residual, 1e-9);
}

TEST(Equilibrium, BadOptionsAndFactorsAreRefused) {
    const Assembly assembly = assemble(sample::star());
    const double descending[] = {0.5, 0.4};
    const double zero[] = {0.0};
    EXPECT_THROW(follow_load_path(assembly, descending), base::InputError);
    EXPECT_THROW(follow_load_path(assembly, zero), base::InputError);
    const double full[] = {1.0};
    EXPECT_THROW(follow_load_path(assembly, full, {.relative_residual = 0.0}), base::InputError);
    EXPECT_THROW(follow_load_path(assembly, full, {.largest_rotation_step = 4.0}), base::InputError);
    EXPECT_THROW(follow_load_path(assembly, full, {.iterations_per_step = 0}), base::InputError);
}

TEST(Equilibrium, MechanismIsRefusedWithItsNode) {
    const Frame frame = sample::hinged_cantilever({2.0, 0.0, 0.0});
    try {
        full_load(frame);
        FAIL();
    } catch (const base::NumericalError& error) {
        EXPECT_THAT(error.what(), testing::HasSubstr("node"));
    }
}

TEST(Equilibrium, NoLoadGivesNoDisplacement) {
    Frame frame = sample::star();
    frame.loads.clear();
    const Solution solution = full_load(frame);
    EXPECT_TRUE(solution.converged());
    EXPECT_EQ(solution.displacements.norm(), 0.0);
    EXPECT_EQ(solution.residual, 0.0);
}

// The residual cannot come to 1e-9: the forces that cancel in the last beam are 1e10 times the load.
TEST(Equilibrium, ShortBeamBesideLongOnesDoesNotEndThePath) {
    const auto tip_of = [](const std::vector<double>& places) {
        Frame frame = sample::cantilever({.section = rectangle_section(0.02, 0.02)});
        const Beam beam = frame.beams[0];
        frame.nodes.clear();
        frame.beams.clear();
        for (const double x : places) frame.nodes.emplace_back(x, 0.0, 0.0);
        for (int i = 1; i < static_cast<int>(places.size()); ++i) {
            frame.beams.push_back(beam);
            frame.beams.back().nodes = {NodeIndex(i - 1), NodeIndex(i)};
        }
        const NodeIndex tip(places.size() - 1);
        frame.loads.push_back({tip, {0.0, 0.0, -1.65}});
        const Solution solution = follow_load_path(assemble(frame), even_load_factors(10)).back();
        EXPECT_TRUE(solution.converged()) << places.size();
        EXPECT_LT(solution.residual, 1e-4);
        return solution.displacements(tip.value, 2);
    };
    const double whole = tip_of({0.0, 2.0});
    EXPECT_NEAR(tip_of({0.0, 1.999, 2.0}), whole, 1e-3 * std::abs(whole));
}

}  // namespace THIS_TEST
}  // namespace fretwork::mechanics
