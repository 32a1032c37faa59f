// SPDX-License-Identifier: GPL-3.0-or-later
#include "sample.hpp"

#include <fretwork/fabrication/facts.hpp>
#include <fretwork/simulation/results/result_subject.hpp>
#include <fretwork/simulation/simulate.hpp>
#include <fretwork/simulation/stages.hpp>

namespace fretwork::fabrication {
namespace THIS_TEST {

using namespace test;
using testing::AllOf;
using testing::Contains;
using testing::Field;
using testing::HasSubstr;
using testing::StartsWith;

/// Held on the left, with a force down at each rim node on the right.
simulation::LoadCase cantilever() {
    simulation::LoadCase load_case;
    load_case.name = "hanging";
    load_case.supports.push_back({simulation::NodesAtSide{simulation::Side::Left}, mechanics::DofSet::all()});
    load_case.loads.push_back({simulation::NodesAtSide{simulation::Side::Right}, {0.0, 0.0, -0.1}});
    return load_case;
}

simulation::Surface sample() {
    simulation::Surface surface = honeycomb(4, 3, {"1-6+3-6", "0-1+1-6"});
    surface.setting.material.density = 1240.0;
    return surface;
}

TEST(Facts, MassIsThatOfTheOutlineAndLessThanThatOfTheBeams) {
    const simulation::Surface surface = sample();
    const Facts known = facts(surface, {}, {});
    const Shape shape = make_shape(surface);
    EXPECT_NEAR(known.mass, area(shape) * shape.height * 1240.0, 1e-12);
    EXPECT_LT(known.mass, known.beam_mass * 1.1);  // round ends at the rim are not in the model
    EXPECT_NEAR(known.cut_length, cut_length(shape), 1e-9);
    EXPECT_EQ(known.pierces, known.pieces + known.openings);
    EXPECT_EQ(known.layers, 10U);  // 2 mm in layers of 0.2 mm
}

TEST(Facts, KerfDoesNotChangeWhatIsLeft) {
    EXPECT_DOUBLE_EQ(facts(sample(), {.kerf = 2e-4}, {}).area, facts(sample(), {}, {}).area);
}

TEST(Facts, AKerfThatClosesOpeningsIsTold) {
    const auto warns = Contains(Field(&Warning::message, HasSubstr("openings: they are not cut")));
    EXPECT_THAT(facts(sample(), {.kerf = 2e-4}, {}).warnings, testing::Not(warns));
    EXPECT_THAT(facts(sample(), {.kerf = 0.06}, {}).warnings, warns);
}

TEST(Facts, AFilletThatDoesNotFitIsTold) {
    const auto warns = Contains(Field(&Warning::message, HasSubstr("mm does not fit in ")));
    EXPECT_THAT(facts(sample(), {.fillet = 1e-4}, {}).warnings, testing::Not(warns));
    EXPECT_THAT(facts(sample(), {.fillet = 0.01}, {}).warnings, warns);
}

TEST(Facts, ASectionThatIsNoRectangleIsTold) {
    const auto warns =
        Contains(Field(&Warning::message, HasSubstr("which stand for the tube of the setting")));
    EXPECT_THAT(facts(sample(), {}, {}).warnings, testing::Not(warns));
    simulation::Surface surface = sample();
    surface.setting.section = mechanics::tube_section(3e-3, 2e-3);
    EXPECT_THAT(facts(surface, {}, {}).warnings, warns);
}

TEST(Facts, SmallestRadiusIsTheFilletOrZero) {
    EXPECT_DOUBLE_EQ(facts(sample(), {}, {}).smallest_radius, 0.0);
    EXPECT_NEAR(facts(sample(), {.fillet = 3e-4}, {}).smallest_radius, 3e-4, 1e-4);
}

TEST(Facts, SmallSagAndStressAreProportionalToWeightAndLoad) {
    const simulation::LoadCase load_case = cantilever();
    simulation::Surface surface = sample();
    surface.setting.material.young_modulus *= 1e7;  // so that displacements are small
    const Facts once = facts(surface, {}, {&load_case, nullptr});
    ASSERT_TRUE(once.sag && once.stress);
    EXPECT_GT(once.sag->deflection, 0.0);
    ASSERT_LT(once.sag->deflection, 1e-2 * once.box.width());
    surface.setting.material.density *= 2.0;
    simulation::LoadCase twice = load_case;
    twice.loads[0].force *= 3.0;
    const Facts more = facts(surface, {}, {&twice, nullptr});
    // Large displacements change both by a share that is of the order of the displacement over the width.
    EXPECT_NEAR(more.sag->deflection, 2.0 * once.sag->deflection, 1e-3 * once.sag->deflection);
    EXPECT_NEAR(more.stress->value, 3.0 * once.stress->value, 1e-6 * once.stress->value);
}

/// A side lies on something, and displacements of the other side are given.
TEST(Facts, SupportsThatDoNotHoldTheSheetAloneCostOnlyTheSag) {
    using mechanics::Dof;
    simulation::LoadCase load_case;
    load_case.name = "pulled";
    load_case.gravity = {0.0, 0.0, -9.81};
    load_case.supports.push_back({simulation::NodesAtSide{simulation::Side::Left},
                                  mechanics::DofSet{{false, false, true, false, false, false}}});
    for (const Dof dof : {Dof::ux, Dof::uy, Dof::uz})
        load_case.prescribed.push_back(
            {simulation::NodesAtSide{simulation::Side::Right}, dof, dof == Dof::ux ? 1e-5 : 0.0});
    const Facts known = facts(sample(), {}, {&load_case, nullptr});
    EXPECT_FALSE(known.sag);
    EXPECT_TRUE(known.stress);
    EXPECT_GT(known.mass, 0.0);
    EXPECT_THAT(known.warnings,
                Contains(Field(&Warning::message, HasSubstr("on the supports alone is not known"))));
}

// For small displacements it would sag by many times its own width.
TEST(Facts, ALimpSheetHangsNoLowerThanItIsWide) {
    const simulation::LoadCase load_case = cantilever();
    simulation::Surface surface = sample();
    const double stiff = facts(surface, {}, {&load_case, nullptr}).sag->deflection;
    const double softer = 10.0 * facts(surface, {}, {}).box.width() / stiff;
    surface.setting.material.young_modulus /= softer;
    const Facts known = facts(surface, {}, {&load_case, nullptr});
    ASSERT_TRUE(known.sag);
    EXPECT_GT(known.sag->deflection, 0.5 * known.box.width());
    EXPECT_LT(known.sag->deflection, known.box.width());
    EXPECT_NEAR(known.sag->weight, known.mass * 9.80665, 1e-6 * known.sag->weight);
}

TEST(Facts, TheSupportsBearTheWeightOfTheOutline) {
    const simulation::LoadCase load_case = cantilever();
    for (const ShapeOptions& shape : {ShapeOptions{}, ShapeOptions{.fillet = 5e-4, .frame_width = 0.004}}) {
        const Facts known = facts(sample(), shape, {&load_case, nullptr});
        ASSERT_TRUE(known.sag);
        EXPECT_GT(std::abs(known.mass / known.beam_mass - 1.0), 0.01);  // so that the two differ clearly
        EXPECT_NEAR(known.sag->weight, known.mass * 9.80665, 1e-8 * known.sag->weight);
    }
}

/// The load case without its forces, pulled down.
simulation::LoadCase pulled(double gravity) {
    simulation::LoadCase load_case = cantilever();
    load_case.loads.clear();
    load_case.gravity = {0.0, 0.0, -gravity};
    return load_case;
}

TEST(Facts, GravityOfALoadCaseBearsOnTheOutlineAndNotOnTheBeams) {
    const simulation::Surface surface = sample();
    const simulation::LoadCase on_outline = pulled(9.81);
    const Facts known = facts(surface, {}, {&on_outline, nullptr});
    ASSERT_TRUE(known.stress);
    const simulation::LoadCase on_beams = pulled(9.81 * known.mass / known.beam_mass);
    simulation::SurfaceResult same = simulation::simulate(surface, on_beams, {.model = "corotational"});
    same.subject = simulation::result_subject(surface, on_beams, {.model = "corotational"});
    EXPECT_NEAR(known.stress->value, facts(surface, {}, {nullptr, &same}).stress->value,
                1e-8 * known.stress->value);
}

TEST(Facts, WithoutGravityTheStressesOfALoadCaseDoNotDependOnWhatIsMade) {
    const simulation::LoadCase load_case = cantilever();
    const Facts thin = facts(sample(), {}, {&load_case, nullptr});
    const Facts heavy = facts(sample(), {.frame_width = 0.006}, {&load_case, nullptr});
    ASSERT_GT(heavy.mass, 1.1 * thin.mass);
    EXPECT_DOUBLE_EQ(heavy.stress->value, thin.stress->value);
}

TEST(Facts, AStressAboveTheStrengthIsToldWithTileAndNode) {
    const simulation::LoadCase load_case = cantilever();
    const Facts known = facts(sample(), {}, {&load_case, nullptr}, {.strength = 1e3});
    EXPECT_THAT(
        known.warnings,
        Contains(Field(&Warning::message, AllOf(HasSubstr("tile "), HasSubstr("node "), HasSubstr("MPa")))));
}

TEST(Facts, AStressOfAResultThatIsNotTheAnswerIsWarnedOf) {
    const simulation::Surface surface = sample();
    const simulation::LoadCase load_case = cantilever();
    simulation::SurfaceResult result = simulation::simulate(surface, load_case, {.model = "corotational"});
    result.subject = simulation::result_subject(surface, load_case, {.model = "corotational"});
    const auto warns = Contains(Field(&Warning::message, StartsWith("the stress of the result: ")));
    EXPECT_THAT(facts(surface, {}, {nullptr, &result}).warnings, testing::Not(warns));
    result.solution.termination = mechanics::Termination::LimitLoad;
    const Facts known = facts(surface, {}, {nullptr, &result});
    EXPECT_THAT(known.warnings, warns);
    for (const Warning& warning : known.warnings) {
        if (warning.message.starts_with("the stress of the result")) {
            EXPECT_FALSE(warning.place) << "it is about the whole surface";
        }
    }
}

/// The load is taken off again in the last stage, where nearly no stress is left.
TEST(Facts, TheLargestStressOfAllLoadStagesIsTakenAndItsStageNamed) {
    const simulation::Surface surface = sample();
    const std::vector<simulation::LoadCase> cases = {cantilever()};
    const auto stages = simulation::parse_stages(R"({"format": "fretwork/stages/1", "stages": [
        {"name": "touch", "loads": [{"load_case": "hanging", "factor": 0.5}]},
        {"name": "press", "loads": [{"load_case": "hanging", "factor": 1}]},
        {"name": "off", "loads": [{"load_case": "hanging", "factor": 0}]}]})",
                                                 "stages.json");
    const simulation::SurfaceResult staged =
        simulation::simulate_stages(surface, {cases.front(), cases, stages}, {.model = "corotational"});
    ASSERT_TRUE(staged.solution.converged());
    const Facts known = facts(surface, {}, {nullptr, &staged});
    ASSERT_TRUE(known.stress);
    EXPECT_EQ(known.stress->source, "the result, load stage press");
    simulation::SurfaceResult pressed = staged;
    pressed.solution = staged.load_steps[1];
    pressed.load_steps.clear();
    const Facts alone = facts(surface, {}, {nullptr, &pressed});
    EXPECT_EQ(alone.stress->source, "the result");
    EXPECT_DOUBLE_EQ(known.stress->value, alone.stress->value);
    EXPECT_EQ(known.stress->node, alone.stress->node);
}

TEST(Facts, TheLoadStepWithTheLargestStressIsNamed) {
    const simulation::Surface surface = sample();
    const simulation::SurfaceResult result =
        simulation::simulate(surface, cantilever(), {.model = "corotational", .load_steps = 3});
    ASSERT_EQ(result.load_steps.size(), 3U);
    const Facts known = facts(surface, {}, {nullptr, &result});
    ASSERT_TRUE(known.stress);
    EXPECT_EQ(known.stress->source, "the result, load step 3") << "the stress grows with the load";
}

TEST(Facts, SharpAnglesAreToldWithTileAndNode) {
    const Facts known = facts(sample(), {}, {}, {.sharp_angle = 3.0});
    EXPECT_THAT(known.warnings,
                Contains(Field(&Warning::message, AllOf(HasSubstr("tile "), HasSubstr("degrees")))));
}

TEST(Facts, OptionsThatMakeNoSenseAreRefused) {
    for (const FactsOptions& wrong : {FactsOptions{.clearance = 0.0}, FactsOptions{.layer_height = -1.0},
                                      FactsOptions{.layer_height = 1e-9}, FactsOptions{.strength = 0.0}})
        EXPECT_THROW((void)facts(sample(), {}, {}, wrong), base::InputError);
}

}  // namespace THIS_TEST
}  // namespace fretwork::fabrication
