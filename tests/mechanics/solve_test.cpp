// SPDX-License-Identifier: GPL-3.0-or-later
#include "sample.hpp"
#include "support.hpp"

#include <fretwork/base/error.hpp>
#include <fretwork/mechanics/decks/calculix_file.hpp>
#include <fretwork/mechanics/frame/frame_file.hpp>
#include <fretwork/mechanics/linear_solver.hpp>
#include <fretwork/mechanics/modes.hpp>
#include <fretwork/mechanics/results/result_file.hpp>
#include <fretwork/mechanics/solve.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace fretwork::mechanics {
namespace THIS_TEST {

using testing::HasSubstr;

std::string complaint(const SolveOptions& options) {
    try {
        options.validate();
    } catch (const base::InputError& error) {
        return error.what();
    }
    return "";
}

TEST(Solve, SolversAreFoundByTheirNames) {
    for (const std::string_view name : solver_names()) EXPECT_EQ(solver_name(find_solver(name)), name);
    EXPECT_THROW(find_solver("guess"), base::InputError);
}

TEST(Solve, LinearSolutionIsThatOfTheLinearSolver) {
    const Assembly assembly = assemble(sample::star());
    const Result result = solve(assembly, {.solver = Solver::Linear});
    EXPECT_EQ(result.solver, "linear");
    EXPECT_EQ(result.solution.displacements, solve_linear(assembly).displacements);
    EXPECT_TRUE(result.load_steps.empty());
    ASSERT_EQ(result.nodes.size(), 4u);
    EXPECT_EQ(result.nodes[2].id, 2);
    EXPECT_GT(result.seconds, 0.0);
}

// P L^3 / 3 E I and P L^2 / 2 E I, with E = 1e-12 Pa and a diameter of 1 mm.
TEST(Solve, DisplacementsThatNoResultHasAreRefused) {
    Frame frame =
        sample::cantilever({.section = circle_section(0.001), .material = {.young_modulus = 1e-12}});
    frame.loads.push_back({NodeIndex(1), {0.0, 0.0, 1.0}});
    const std::string refusal = test::complaint_of([&] {
        solve(LabelledFrame{frame, {}, "soft.json"}, {.solver = Solver::Linear});
    });
    EXPECT_THAT(refusal, testing::StartsWith("soft.json: the largest displacement is 6.79e+24 m, the largest "
                                             "rotation 1.02e+25 rad, where results have at most 1e+12 m and "
                                             "1e+06 rad: "));
    EXPECT_THAT(refusal, HasSubstr("out of any sensible range"));
}

// The limits of solutions are those of files, for each component: half a limit is read back, twice the limit
// is refused. The tip turns by M L / E I about y, or moves by N L / E A along x.
TEST(Solve, DisplacementsThatAreNotRefusedAreReadBack) {
    for (const auto& [force, moment] : {std::pair{0.0, 1e6 * 1e3}, std::pair{1e12 * 1e3, 0.0}}) {
        Frame frame = sample::cantilever({.section = {.area = 1e-6, .I2 = 1e-6, .I3 = 1e-6, .J = 1e-6}});
        frame.loads.push_back({NodeIndex(1), {0.5 * force, 0.0, 0.0}, {0.0, 0.5 * moment, 0.0}});
        const Result result = solve(assemble(frame), {.solver = Solver::Linear});
        EXPECT_EQ(parse_result(result_text(result), "text").solution.displacements,
                  result.solution.displacements);
        frame.loads.push_back({NodeIndex(1), {1.5 * force, 0.0, 0.0}, {0.0, 1.5 * moment, 0.0}});
        EXPECT_THROW(solve(assemble(frame), {.solver = Solver::Linear}), base::NumericalError);
    }
}

TEST(Solve, PathIsJoinedAndKeptOnlyIfStepsWereAskedFor) {
    const Assembly assembly = assemble(sample::star());
    const Result kept = solve(assembly, {.steps = 10});
    ASSERT_EQ(kept.load_steps.size(), 10u);
    int iterations = 0;
    for (const Solution& step : kept.load_steps) iterations += step.iterations;
    EXPECT_EQ(kept.solution.iterations, iterations);
    EXPECT_EQ(kept.solution.displacements, kept.load_steps.back().displacements);
    const Result end = solve(assembly);
    EXPECT_TRUE(end.load_steps.empty());
    EXPECT_EQ(end.solution.displacements, kept.solution.displacements);
}

TEST(Solve, FrameIsSolvedAsItsAssembly) {
    const LabelledFrame frame{sample::star(), {11, 12, 13, 14}};
    const Result result = solve(frame, {.estimate_error = true, .vibration_modes = 2});
    EXPECT_EQ(result.solution.displacements, solve(assemble(frame.frame)).solution.displacements);
    EXPECT_EQ(result.nodes[3].id, 14);
    EXPECT_EQ(result.vibration_modes.size(), 2u);
    ASSERT_TRUE(result.discretization_error.has_value());
    EXPECT_TRUE(result.discretization_error->known);
}

TEST(Solve, OptionsThatTheSolverWouldIgnoreAreRefused) {
    EXPECT_EQ(complaint({.steps = 3, .branch = Branch::Stable, .threads = 2, .estimate_error = true}), "");
    EXPECT_EQ(complaint({.solver = Solver::Linear, .threads = 2, .buckling_modes = 1}), "");
    EXPECT_THAT(complaint({.solver = Solver::Linear, .steps = 3}), HasSubstr("steps works with"));
    EXPECT_THAT(complaint({.solver = Solver::Linear, .branch = Branch::Primary}), HasSubstr("branch works"));
    EXPECT_THAT(complaint({.solver = Solver::Linear, .estimate_error = true}), HasSubstr("newton"));
    EXPECT_THAT(complaint({.branch = Branch::Snapping, .estimate_error = true}), HasSubstr("limit loads"));
    EXPECT_THAT(complaint({.rotational_mass = RotationalMass::Natural}), HasSubstr("dynamic-relaxation"));
    EXPECT_THAT(complaint({.solver = Solver::DynamicRelaxation, .threads = 2}), HasSubstr("one thread"));
    EXPECT_THAT(complaint({.steps = 0}), HasSubstr("steps is 0"));
    for (const int modes : {-1, kMostModes + 1}) {
        const std::string refused =
            "the number of modes is " + std::to_string(modes) + ", where 0 to 1000 are possible";
        EXPECT_EQ(complaint({.vibration_modes = modes}), refused);
        EXPECT_EQ(complaint({.buckling_modes = modes}), refused);
    }
    EXPECT_THROW(solve(assemble(sample::star()), {.estimate_error = true}), base::InputError);
    EXPECT_THROW(solve(assemble(sample::star()), {.lumped_gravity = true}), base::InputError);
}

TEST(Solve, StructureIsReadByTheEndingOfItsFile) {
    const test::TemporaryFolder folder;
    const auto json = folder.path() / "frame.json";
    const auto deck = folder.path() / "frame.inp";
    write_frame(sample::star(), json);
    write_calculix(sample::star(), deck);
    EXPECT_EQ(read_structure(json).labels, (std::vector{0, 1, 2, 3}));
    EXPECT_EQ(read_structure(json).source, json.string());
    EXPECT_EQ(read_structure(deck).labels, (std::vector{1, 2, 3, 4}));
    const auto capitals = folder.path() / "OTHER.INP";
    write_calculix(sample::star(), capitals);
    EXPECT_EQ(read_structure(capitals).labels, (std::vector{1, 2, 3, 4}));
}

/// A cantilever with a second beam that hangs on its tip by a hinge.
LabelledFrame mechanism() {
    LabelledFrame loose{sample::cantilever(), {0, 1, 2}, "loose.json"};
    loose.frame.nodes.emplace_back(2.0, 0.0, 0.0);
    loose.frame.beams.push_back(loose.frame.beams[0]);
    loose.frame.beams[1].nodes = {NodeIndex(1), NodeIndex(2)};
    loose.frame.beams[1].releases = {{0, {{false, false, false, false, true, false}}}};
    return loose;
}

TEST(Solve, MechanismIsRefusedWithTheNameOfItsFile) {
    try {
        solve(mechanism(), {.solver = Solver::Linear});
        FAIL();
    } catch (const base::NumericalError& error) {
        EXPECT_THAT(error.what(), testing::StartsWith("loose.json: the structure"));
    }
}

TEST(Solve, ModesThatCannotBeFoundCostNoPath) {
    LabelledFrame light = mechanism();  // the error of its path must not come first
    for (Beam& beam : light.frame.beams) beam.material.density = 0.0;
    EXPECT_THAT(test::complaint_of([&] { (void)solve(light, {.vibration_modes = 1}); }),
                HasSubstr("no mass to vibrate"));
}

}  // namespace THIS_TEST
}  // namespace fretwork::mechanics
