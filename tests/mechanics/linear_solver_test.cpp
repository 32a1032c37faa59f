// SPDX-License-Identifier: GPL-3.0-or-later
#include "hinged_cantilever.hpp"
#include "sample.hpp"

#include <fretwork/base/error.hpp>
#include <fretwork/geometry/rotation.hpp>
#include <fretwork/mechanics/linear_solver.hpp>
#include <fretwork/mechanics/paths/equilibrium.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace fretwork::mechanics {
namespace THIS_TEST {

using Eigen::Vector3d;
using sample::CantileverShape;

Vector3d sum_of_forces(const Frame& frame, const NodeValues& values) {
    Vector3d sum = Vector3d::Zero();
    for (std::size_t i = 0; i < frame.nodes.size(); ++i)
        sum += values.row(static_cast<Eigen::Index>(i)).head<3>();
    return sum;
}

Vector3d sum_of_moments(const Frame& frame, const NodeValues& values) {
    Vector3d sum = Vector3d::Zero();
    for (std::size_t i = 0; i < frame.nodes.size(); ++i) {
        const auto row = values.row(static_cast<Eigen::Index>(i));
        const Vector3d force = row.head<3>();
        sum += frame.nodes[i].cross(force) + Vector3d(row.tail<3>());
    }
    return sum;
}

TEST(LinearSolver, CantileverMatchesItsClosedForms) {
    const CantileverShape shape;
    const double bending2 = 1e9 * shape.section.I2;
    const double bending3 = 1e9 * shape.section.I3;
    for (const int divisions : {1, 7}) {
        Frame frame = sample::cantilever({.divisions = divisions});
        frame.loads.push_back({NodeIndex(1), {3.0, 5.0, 7.0}, {11.0, 0.0, 0.0}});
        const Solution solution = solve_linear(assemble(frame));
        const auto tip = solution.displacements.row(1);
        EXPECT_NEAR(tip[0], 3.0 / (1e9 * 0.01), 1e-17);
        EXPECT_NEAR(tip[1], 5.0 / (3.0 * bending3), 1e-13);
        EXPECT_NEAR(tip[2], 7.0 / (3.0 * bending2), 1e-13);
        EXPECT_NEAR(tip[3], 11.0 / (5e8 * shape.section.J), 1e-13);
        EXPECT_NEAR(tip[4], -7.0 / (2.0 * bending2), 1e-13);
        EXPECT_NEAR(tip[5], 5.0 / (2.0 * bending3), 1e-13);
        EXPECT_NEAR(solution.reactions(0, 4), 7.0, 1e-11);
        EXPECT_NEAR(solution.energy, 0.5 * (3.0 * tip[0] + 5.0 * tip[1] + 7.0 * tip[2] + 11.0 * tip[3]),
                    1e-15);
    }
}

TEST(LinearSolver, ShearAreasAddTheShearDeflection) {
    CantileverShape shape;
    shape.section.shear_area2 = 0.004;
    shape.section.shear_area3 = 0.006;
    Frame frame = sample::cantilever(shape);
    frame.loads.push_back({NodeIndex(1), {0.0, 5.0, 7.0}});
    const Solution solution = solve_linear(assemble(frame));
    EXPECT_NEAR(solution.displacements(1, 1), 5.0 / (3.0 * 2e3) + 5.0 / (5e8 * 0.004), 1e-14);
    EXPECT_NEAR(solution.displacements(1, 2), 7.0 / (3.0 * 1e3) + 7.0 / (5e8 * 0.006), 1e-14);
}

TEST(LinearSolver, ConsistentGravityIsExactForAnyDivisionAndLumpedIsNot) {
    const double line_load = 1000.0 * 0.01 * 9.81;
    const double exact = -line_load / (8.0 * 1e3);
    for (const int divisions : {1, 3}) {
        Frame frame = sample::cantilever({.divisions = divisions});
        frame.gravity = {0.0, 0.0, -9.81};
        const Solution solution = solve_linear(assemble(frame));
        EXPECT_NEAR(solution.displacements(1, 2), exact, 1e-12);
        EXPECT_NEAR(solution.reactions(0, 2), line_load, 1e-9);
        EXPECT_NEAR(solution.reactions(0, 4), -line_load / 2.0, 1e-9);
    }
    Frame frame = sample::cantilever();
    frame.gravity = {0.0, 0.0, -9.81};
    const Solution lumped = solve_linear(assemble(frame, {.lumped_gravity = true}));
    EXPECT_NEAR(lumped.displacements(1, 2), -line_load / (6.0 * 1e3), 1e-12);
}

// A propped cantilever under a load at midspan: the prop takes 5/16 of it.
TEST(LinearSolver, ProppedCantileverMatchesItsClosedForm) {
    Frame frame = sample::cantilever();
    frame.nodes = {{0, 0, 0}, {2, 0, 0}, {1, 0, 0}};
    frame.beams.push_back(frame.beams[0]);
    frame.beams[0].nodes = {NodeIndex(0), NodeIndex(2)};
    frame.beams[1].nodes = {NodeIndex(2), NodeIndex(1)};
    frame.supports.push_back({NodeIndex(1), {{false, true, true, false, false, false}}});
    frame.loads.push_back({NodeIndex(2), {0.0, 0.0, -16.0}});
    const Solution solution = solve_linear(assemble(frame));
    EXPECT_NEAR(solution.reactions(1, 2), 5.0, 1e-11);
    EXPECT_NEAR(solution.reactions(0, 2), 11.0, 1e-11);
    EXPECT_NEAR(solution.displacements(2, 2), -7.0 * 16.0 * 8.0 / (768.0 * 1e3), 1e-13);
}

// A beam on two hinges sags by 5 q l^4 / (384 E I), whatever it is divided into, and hands over no moment.
TEST(LinearSolver, HingedBeamUnderOwnWeightMatchesClosedForm) {
    for (const int divisions : {1, 2, 5}) {
        Frame frame = sample::cantilever();
        frame.nodes = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
        frame.beams.push_back(frame.beams[0]);
        frame.beams[1].nodes = {NodeIndex(1), NodeIndex(2)};
        frame.beams[0].releases = {{0, {{false, false, false, false, true, false}}}};
        frame.beams[1].releases = {{1, {{false, false, false, false, true, false}}}};
        for (Beam& beam : frame.beams) beam.divisions = divisions;
        sample::clamp(frame, 2);
        frame.gravity = {0, 0, -9.81};
        const Solution solution = solve_linear(assemble(frame));
        const double weight = 1000.0 * 0.01 * 9.81;  // N/m
        const double exact = -5.0 * weight * 16.0 / (384.0 * 1e9 * 1e-6);
        EXPECT_NEAR(solution.displacements(1, 2), exact, 1e-9 * std::abs(exact)) << divisions;
        EXPECT_NEAR(solution.reactions(0, 4), 0.0, 1e-9 * weight) << divisions;
        EXPECT_NEAR(solution.reactions(0, 2), weight, 1e-9 * weight) << divisions;
    }
}

TEST(LinearSolver, HingePassesNoMoment) {
    // Two cantilevers that meet in a hinge share the load as two springs 3 E I / L^3.
    Frame frame = sample::hinged_cantilever({3.0, 0.0, 0.0});
    sample::clamp(frame, 2);
    frame.loads.push_back({NodeIndex(1), {0.0, 0.0, -1.0}});
    for (const int divisions : {1, 4}) {
        for (Beam& beam : frame.beams) beam.divisions = divisions;
        const Solution solution = solve_linear(assemble(frame));
        EXPECT_NEAR(solution.displacements(1, 2), -1.0 / (3e3 + 3e3 / 8.0), 1e-13);
    }
}

TEST(LinearSolver, BarHingedAtBothEndsIsATrussBar) {
    // Symmetric two-bar truss: 2 E A / l sin^2 a per unit displacement.
    Frame frame;
    frame.nodes = {{-0.4, 0, 0}, {0, 0, -0.3}, {0.4, 0, 0}};
    for (const auto& [from, to] : {std::pair{0, 1}, std::pair{1, 2}}) {
        Beam beam = sample::beam_between(from, to);
        beam.releases = {{0, {{false, false, false, true, true, true}}},
                         {1, {{false, false, false, true, true, true}}}};
        frame.beams.push_back(beam);
    }
    sample::clamp(frame, 0);
    sample::clamp(frame, 2);
    frame.supports.push_back({NodeIndex(1), {{false, true, false, true, true, true}}});
    frame.loads.push_back({NodeIndex(1), {0.0, 0.0, -1.0}});
    const Solution solution = solve_linear(assemble(frame));
    const double stiffness = 2.0 * 1e9 * 4e-6 / 0.5 * 0.36;
    EXPECT_NEAR(solution.displacements(1, 2), -1.0 / stiffness, 1e-15);
    EXPECT_LT(solution.reactions.rightCols<3>().norm(), 1e-12);
}

TEST(LinearSolver, PrescribedDisplacementIsReachedWithItsReaction) {
    Frame frame = sample::cantilever();
    frame.prescribed.push_back({NodeIndex(1), Dof::uz, 0.01});
    const Solution solution = solve_linear(assemble(frame));
    EXPECT_DOUBLE_EQ(solution.displacements(1, 2), 0.01);
    EXPECT_NEAR(solution.reactions(1, 2), 3e3 * 0.01, 1e-10);
    EXPECT_NEAR(solution.energy, 0.5 * 3e3 * 1e-4, 1e-12);
}

/// Constant strain states that any mesh of collinear beams must give exactly, unequal lengths included.
TEST(LinearSolver, PatchTestOfUnequalBeamsGivesConstantStrains) {
    Frame frame = sample::cantilever();
    frame.nodes = {{0, 0, 0}, {1, 0, 0}, {0.13, 0, 0}, {0.7, 0, 0}};
    const Beam beam = frame.beams[0];
    frame.beams.clear();
    for (const auto& [from, to] : {std::pair{0, 2}, std::pair{3, 2}, std::pair{3, 1}}) {
        frame.beams.push_back(beam);
        frame.beams.back().nodes = {NodeIndex(from), NodeIndex(to)};
    }
    frame.loads.push_back({NodeIndex(1), {1e5, 0, 0}, {100.0, 200.0, 300.0}});
    const Solution solution = solve_linear(assemble(frame));
    for (Eigen::Index i = 0; i < 4; ++i) {
        const double x = frame.nodes[i].x();
        EXPECT_NEAR(solution.displacements(i, 0), 1e-2 * x, 1e-12);
        EXPECT_NEAR(solution.displacements(i, 3), 100.0 / (5e8 * 2.5e-6) * x, 1e-12);
        EXPECT_NEAR(solution.displacements(i, 2), -0.1 * x * x, 1e-11);
        EXPECT_NEAR(solution.displacements(i, 1), 0.075 * x * x, 1e-11);
    }
}

TEST(LinearSolver, ReactionsBalanceTheLoads) {
    for (Frame frame : {sample::star(), sample::flat_wheel()}) {
        frame.gravity = {1.0, 2.0, -9.81};
        frame.loads.push_back({NodeIndex(3), {0.1, 0.2, 0.3}, {0.001, -0.002, 0.003}});
        const Assembly assembly = assemble(frame);
        const Solution solution = solve_linear(assembly);
        EXPECT_LT((sum_of_forces(frame, solution.reactions) + sum_of_forces(frame, assembly.loads)).norm(),
                  1e-12);
        EXPECT_LT((sum_of_moments(frame, solution.reactions) + sum_of_moments(frame, assembly.loads)).norm(),
                  1e-13);
        EXPECT_LT(solution.residual, 1e-12);
    }
}

TEST(LinearSolver, WorkOfTwoLoadsIsReciprocal) {
    const Frame frame = sample::flat_wheel();
    const Assembly assembly = assemble(frame);
    LinearSolver solver(assembly);
    sample::Random random(11);
    NodeValues one(12, kDofsPerNode), other(12, kDofsPerNode);
    for (double& value : one.reshaped()) value = random.next();
    for (double& value : other.reshaped()) value = random.next();
    const double work = one.cwiseProduct(solver.solve(other).displacements).sum();
    EXPECT_NEAR(other.cwiseProduct(solver.solve(one).displacements).sum(), work, 1e-10 * std::abs(work));
}

TEST(LinearSolver, TiltedFlatFrameGivesRotatedSolution) {
    // Flat, it is solved as two decoupled halves; tilted, as one problem.
    Frame frame = sample::flat_wheel();
    frame.loads.push_back({NodeIndex(4), {0.5, -0.3, 0.7}, {0.001, 0.002, 0.003}});
    const Solution flat = solve_linear(assemble(frame));
    const Eigen::Quaterniond turn = geometry::exponential({0.4, -0.8, 0.3});
    for (Vector3d& node : frame.nodes) node = turn * node;
    for (Beam& beam : frame.beams) beam.normal = turn * Vector3d::UnitZ();
    frame.loads[0].force = turn * frame.loads[0].force;
    frame.loads[0].moment = turn * frame.loads[0].moment;
    const Solution tilted = solve_linear(assemble(frame));
    for (Eigen::Index i = 0; i < 12; ++i) {
        for (const int part : {0, 3}) {
            const Vector3d expected = turn * Vector3d(flat.displacements.row(i).segment<3>(part).transpose());
            const Vector3d found = tilted.displacements.row(i).segment<3>(part);
            EXPECT_LT((found - expected).norm(), 1e-11 * flat.displacements.norm());
        }
    }
}

TEST(LinearSolver, FlatFrameOfTurnedSectionsIsNotSplit) {
    Frame frame = sample::flat_wheel();
    for (Beam& beam : frame.beams) {
        beam.section = rectangle_section(0.002, 0.004);
        beam.normal = Vector3d(0.0, 0.4, 1.0);
    }
    frame.loads.push_back({NodeIndex(4), {0.0, 0.0, 1.0}});
    const Assembly assembly = assemble(frame);
    const Solution solution = solve_linear(assembly);
    EXPECT_GT(solution.displacements.leftCols<2>().norm(), 1e-4 * solution.displacements.norm());
    EXPECT_LT(solution.residual, 1e-12);
}

TEST(LinearSolver, UpdatedSolverGivesBitsOfNewSolver) {
    Frame frame = sample::flat_wheel();
    frame.loads.push_back({NodeIndex(4), {0.5, -0.3, 0.7}});
    LinearSolver solver(assemble(frame));
    for (Beam& beam : frame.beams) beam.section = rectangle_section(0.003, 0.001);
    solver.update(assemble(frame));
    const Solution expected = solve_linear(assemble(frame));
    EXPECT_EQ(solver.solve().displacements, expected.displacements);
    for (Beam& beam : frame.beams) beam.normal = Vector3d(0.0, 0.4, 1.0);  // couples the halves
    solver.update(assemble(frame));
    EXPECT_EQ(solver.solve().displacements, solve_linear(assemble(frame)).displacements);
}

TEST(LinearSolver, MechanismIsNamedByItsNode) {
    // Only a hinge holds the second beam: it swings.
    const Frame frame = sample::hinged_cantilever({2.0, 0.0, 0.0});
    try {
        solve_linear(assemble(frame));
        FAIL();
    } catch (const base::NumericalError& error) {
        EXPECT_THAT(error.what(), testing::HasSubstr("without strain"));
        EXPECT_THAT(error.what(), testing::AnyOf(testing::HasSubstr("node 1"), testing::HasSubstr("node 2")));
    }
}

std::string refusal_of(const Frame& frame) {
    try {
        solve_linear(assemble(frame));
        return "";
    } catch (const base::NumericalError& error) {
        return error.what();
    }
}

TEST(LinearSolver, TellsThatNothingIsHeld) {
    Frame frame = sample::cantilever({.divisions = 3});
    frame.supports.clear();
    EXPECT_EQ(refusal_of(frame), "nothing holds the structure: it needs supports");
}

TEST(LinearSolver, TellsThePartThatIsNotHeld) {
    Frame frame = sample::cantilever({.divisions = 3});
    const Beam beam = frame.beams.front();
    const auto first = static_cast<int>(frame.nodes.size());
    frame.nodes.insert(frame.nodes.end(), {{5, 5, 0}, {6, 5, 0}});
    frame.beams.push_back(beam);
    frame.beams.back().nodes = {NodeIndex(first), NodeIndex(first + 1)};
    EXPECT_THAT(
        refusal_of(frame),
        testing::MatchesRegex(
            "nothing holds the part of the structure with .*node [23], .5.*, 5, 0.: it needs supports.*"));
}

// Neither is it taken for a mechanism, nor has rounding eaten more than frame.hpp tells: P L^3 / 3 E I under
// a force at the tip, and q L^4 / 8 E I under its own weight.
TEST(LinearSolver, CantileverOfMostDivisionsIsAsStiffAsOneElement) {
    const Frame bare = sample::cantilever({.divisions = kMostDivisions});
    Frame pushed = bare;
    pushed.loads.push_back({NodeIndex(1), {0.0, 0.0, 1.0}});
    EXPECT_NEAR(solve_linear(assemble(pushed)).displacements(1, 2), 1.0 / 3e3, 1e-5 / 3e3);
    Frame heavy = bare;
    heavy.gravity = {0.0, 0.0, -9.81};
    const double deflection = 1000.0 * 0.01 * 9.81 / 8e3;
    EXPECT_NEAR(solve_linear(assemble(heavy)).displacements(1, 2), -deflection, 1e-5 * deflection);
}

/// Three beams askew with three hinges and two held components: one beam can turn, and pivots are rounding,
/// but do not quite vanish.
Frame mechanism_held_by_rounding() {
    Frame frame;
    frame.nodes = {{1.1401849792374885, 0.04902517847235538, 0.08276786191279123},
                   {1.7918265125843806, -0.180973948197056, 0.27608798382494226},
                   {2.251139670116678, -0.4652615178060602, 0.39737734114979156},
                   {2.941454921257982, -0.6224226893645355, -0.2083427225616376}};
    for (int i = 0; i < 3; ++i) {
        frame.beams.push_back(sample::beam_between(i, i + 1));
        frame.beams.back().section = circle_section(0.04879938469331978);
    }
    frame.beams[0].releases = {{1, {{false, false, false, false, true, true}}}};
    frame.beams[1].releases = {{1, {{false, false, false, false, true, false}}}};
    sample::clamp(frame, 0);
    frame.supports.push_back({NodeIndex(3), {{false, true, true, false, false, false}}});
    return frame;
}

TEST(LinearSolver, MechanismHeldByRoundingIsRefusedLoadedOrNot) {
    Frame turned = mechanism_held_by_rounding();
    turned.loads.push_back({NodeIndex(1), {0, 0, 0}, {0.001, 0.003, 0.0}});
    EXPECT_THROW(solve_linear(assemble(turned)), base::NumericalError);
    EXPECT_THROW(follow_load_path(assemble(turned), even_load_factors(1)), base::NumericalError);
    Frame pushed = mechanism_held_by_rounding();
    pushed.loads.push_back({NodeIndex(0), {0.1, 0.0, 0.2}});  // straight into the support
    EXPECT_THROW(solve_linear(assemble(pushed)), base::NumericalError);
    EXPECT_THROW(follow_load_path(assemble(pushed), even_load_factors(1)), base::NumericalError);
}

/// A cantilever of 20 mm bars, of which the last is `length` long: a stiff part beside soft ones.
Frame with_a_short_last_beam(double length) {
    Frame frame = sample::cantilever({.section = rectangle_section(0.02, 0.02)});
    frame.nodes = {{0, 0, 0}, {1.0 - length, 0, 0}, {1, 0, 0}};
    frame.beams.push_back(frame.beams[0]);
    frame.beams[1].nodes = {NodeIndex(1), NodeIndex(2)};
    frame.loads.push_back({NodeIndex(2), {0.0, 0.0, 1.0}});
    return frame;
}

// A beam of a millimetre beside one of a metre: the forces that cancel are 1e10 times the load.
TEST(LinearSolver, ResidualThatRoundingExplainsIsConverged) {
    const Solution solution = solve_linear(assemble(with_a_short_last_beam(1e-3)));
    EXPECT_TRUE(solution.converged());
    EXPECT_GT(solution.residual, 1e-9);
    EXPECT_NEAR(solution.displacements(2, 2), 1.0 / (3.0 * 1e9 * std::pow(0.02, 4) / 12.0), 1e-6);
}

// The rest that rounding leaves differs from one length and one compiler to the next; so many lengths are
// tried, down to those at which the structure is refused as a mechanism.
TEST(LinearSolver, SolutionWithLargeResidualHasNotConverged) {
    int not_converged = 0;
    for (double length = 1e-4; length > 2.5e-5; length *= 0.98) {
        try {
            const Solution solution = solve_linear(assemble(with_a_short_last_beam(length)));
            EXPECT_EQ(solution.converged(), solution.residual <= 1e-4) << length;
            if (solution.termination == Termination::IterationsSpent) ++not_converged;
        } catch (const base::NumericalError&) {
            break;
        }
    }
    EXPECT_GT(not_converged, 0);
}

/// Asks to stop as soon as it is told of a step.
class StopAtFirstStep final : public base::Progress {
  public:
    void start(std::string_view, std::size_t) override {}
    void update(std::size_t) override { source.request_stop(); }
    void finish() override {}
    base::Control control() { return {.stop = source.get_token(), .progress = this}; }
    std::stop_source source;
};

TEST(LinearSolver, StopsWhenAskedTo) {
    const Assembly assembly = assemble(sample::flat_wheel());
    for (const int threads : {1, 2}) {
        StopAtFirstStep stop;
        EXPECT_THROW(solve_linear(assembly, {.threads = threads, .control = stop.control()}), base::Stopped);
    }
}

TEST(LinearSolver, IsAsItWasAfterAStoppedUpdate) {
    Frame frame = sample::flat_wheel();
    frame.loads.push_back({NodeIndex(4), {0.5, -0.3, 0.7}});
    LinearSolver solver(assemble(frame));
    const Solution before = solver.solve();
    for (Beam& beam : frame.beams) beam.section = rectangle_section(0.003, 0.001);
    StopAtFirstStep stop;
    EXPECT_THROW(solver.update(assemble(frame), stop.control()), base::Stopped);
    EXPECT_EQ(solver.solve().displacements, before.displacements);
    EXPECT_THROW((void)solver.solve({.stop = stop.source.get_token()}), base::Stopped);
    solver.update(assemble(frame));
    EXPECT_EQ(solver.solve().displacements, solve_linear(assemble(frame)).displacements);
}

}  // namespace THIS_TEST
}  // namespace fretwork::mechanics
