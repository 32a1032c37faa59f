// SPDX-License-Identifier: GPL-3.0-or-later
#include "honeycomb.hpp"
#include "support.hpp"

#include <fretwork/simulation/load_cases/stage_conditions.hpp>
#include <fretwork/simulation/results/beam_table.hpp>
#include <fretwork/simulation/results/comparison.hpp>
#include <fretwork/simulation/results/model_doubt.hpp>
#include <fretwork/simulation/results/result_subject.hpp>
#include <fretwork/simulation/simulate.hpp>
#include <fretwork/simulation/stages.hpp>

namespace fretwork::simulation {
namespace THIS_TEST {

using test::cantilever;
using test::complaint_of;
using test::honeycomb;
using testing::HasSubstr;

Surface strip() {
    return make_surface(honeycomb(4, 2, {"0-1+1-6"}), nullptr);
}

LoadCase named(const char* name, double force) {
    LoadCase load_case = cantilever({0.0, 0.0, force});
    load_case.name = name;
    return load_case;
}

simulation::SurfaceResult staged(const std::vector<LoadCase>& cases, const char* stages) {
    const std::vector<LoadStage> parsed = parse_stages(stages, "stages.json");
    return simulate_stages(strip(), {cases.front(), cases, parsed},
                           {.model = "corotational", .estimate_where_doubtful = true});
}

/// A stage applies the same loads as the load case alone.
TEST(Stages, ApplyALoadCaseWhateverItIsCalled) {
    const std::vector<LoadCase> cases = {named("tip", -0.01), named("stage", -0.02)};
    const auto result = staged(cases, R"({"format": "fretwork/stages/1", "stages": [
        {"name": "press", "loads": [{"load_case": "stage", "factor": 1}]}]})");
    ASSERT_TRUE(result.solution.converged());
    const auto alone = simulate(strip(), cases[1], {.model = "corotational"});
    EXPECT_LT((result.solution.displacements - alone.solution.displacements).norm(),
              1e-6 * alone.solution.displacements.norm());  // two paths to one equilibrium
    Session session(strip(), cases[1], {.model = "corotational"});
    const double turn = model_doubt(session, session.solve()).tile_rotation;
    ASSERT_TRUE(result.model_doubt);
    EXPECT_GT(turn, 0.0);
    EXPECT_NEAR(result.model_doubt->tile_rotation, turn, 1e-6 * turn);
}

TEST(Stages, LeaveNothingBehindWhereTheLoadIsTakenOff) {
    const auto result = staged({named("tip", -0.01)}, R"({"format": "fretwork/stages/1", "stages": [
        {"name": "press", "loads": [{"load_case": "tip", "factor": 1}]},
        {"name": "off", "loads": [{"load_case": "tip", "factor": 0}]}]})");
    ASSERT_EQ(result.load_steps.size(), 2U);
    EXPECT_LT(result.solution.displacements.norm(), 1e-6 * result.load_steps.front().displacements.norm());
}

TEST(Stages, ACaseThatIsNotThereIsNamed) {
    EXPECT_THAT(complaint_of([&] {
                    (void)staged({named("tip", -0.01)}, R"({"format": "fretwork/stages/1", "stages": [
        {"name": "press", "loads": [{"load_case": "tap", "factor": 1}]}]})");
                }),
                HasSubstr("tip"));
}

TEST(Stages, AreReadBackFromTheirTextAsTheyWere) {
    const auto stages = parse_stages(R"({"format": "fretwork/stages/1", "stages": [
        {"name": "press", "loads": [{"load_case": "tip", "factor": 2}]},
        {"name": "clip", "keep": [{"side": "right", "fixed": ["uz"]}]},
        {"name": "push", "prescribed": [{"nearest": [[0.1, 0.2]], "uz": -0.01}]},
        {"name": "let go", "free": [{"box": [0, 0, 1, 1], "fixed": ["uz", "rx"]}]}]})",
                                     "stages.json");
    const std::string text = stages_text(stages);
    const auto again = parse_stages(text, "again");
    ASSERT_EQ(again.size(), 4U);
    EXPECT_EQ(stages_text(again), text);
    EXPECT_EQ(again[0].loads[0].factor, 2.0);
    EXPECT_TRUE(again[1].keep[0].fixed.contains[2]);
    EXPECT_EQ(again[2].prescribed[0].value, -0.01);
    EXPECT_TRUE(again[3].free[0].fixed.contains[3]);
}

TEST(Stages, KeepCirclesInTheirSecondFormat) {
    const auto text_of_format = [](const char* format) {
        return std::string(R"({"format": "fretwork/stages/)") + format +
               R"(", "stages": [{"name": "clip",
            "keep": [{"circle": {"center": [0.1, 0.2], "radius": 0.05}, "fixed": ["uz"]}]}]})";
    };
    const auto stages = parse_stages(text_of_format("2"), "stages.json");
    EXPECT_EQ(stages[0].keep[0].where, Selection(NodesInCircle{{0.1, 0.2}, 0.05}));
    EXPECT_THAT(stages_text(stages), HasSubstr("fretwork/stages/2"));
    EXPECT_EQ(stages_text(parse_stages(stages_text(stages), "again")), stages_text(stages));
    EXPECT_THAT(complaint_of([&] { (void)parse_stages(text_of_format("1"), "stages.json"); }),
                HasSubstr("no circle; fretwork/stages/2 has"));
}

TEST(Stages, NameThePlaceOfAWrongEntry) {
    const auto complaint = [](const char* stage) {
        return complaint_of([&] {
            (void)parse_stages(std::string(R"({"format": "fretwork/stages/1", "stages": [)") + stage + "]}",
                               "s.json");
        });
    };
    EXPECT_THAT(complaint(R"({"name": "clip", "keep": [{"side": "right", "fixed": ["uw"]}]})"),
                testing::StartsWith("s.json: /stages/0/keep/0/fixed/0: "));
    EXPECT_THAT(complaint(R"({"name": "let go", "free": [{"sode": "right", "fixed": ["uz"]}]})"),
                testing::StartsWith("s.json: /stages/0/free/0/sode: "));
    EXPECT_THAT(complaint(R"({"name": "push", "prescribed": [{"side": "right", "uz": "far"}]})"),
                testing::StartsWith("s.json: /stages/0/prescribed/0/uz: "));
    EXPECT_THAT(complaint(R"({"name": "press", "loads": [{"load_case": "tip", "factor": -1e300}]})"),
                testing::StartsWith("s.json: /stages/0/loads/0/factor: is -1e+300, where a number from "
                                    "-1e+06 to 1e+06 (times the load case) is needed"));
}

TEST(Stages, HaveNamesOfTheirOwn) {
    const char* twice = R"({"format": "fretwork/stages/1", "stages": [
        {"name": "press", "loads": [{"load_case": "tip", "factor": 1}]},
        {"name": "off", "loads": [{"load_case": "tip", "factor": 0}]},
        {"name": "press", "loads": [{"load_case": "tip", "factor": 2}]}]})";
    EXPECT_EQ(complaint_of([&] { (void)parse_stages(twice, "s.json"); }),
              "s.json: /stages/2/name: 'press' is the name of /stages/0 already; each stage needs a name of "
              "its own");
    const std::vector<LoadCase> cases = {named("tip", -0.01)};
    const std::vector<LoadStage> stages = {{.name = "press", .loads = {{"tip", 1.0}}},
                                           {.name = "press", .loads = {{"tip", 0.0}}}};
    EXPECT_EQ(complaint_of([&] {
                  (void)simulate_stages(strip(), {cases.front(), cases, stages}, {.model = "corotational"});
              }),
              "load stage 'press': is there twice, in positions 1 and 2; each stage needs a name of its own");
}

TEST(Stages, AreAPartOfWhatAResultIsAResultOf) {
    const auto of = [](double force, const std::string& factor) {
        return *staged({named("tip", force)}, (R"({"format": "fretwork/stages/1", "stages": [
            {"name": "press", "loads": [{"load_case": "tip", "factor": )" +
                                               factor + "}]}]}")
                                                  .c_str())
                    .subject;
    };
    const simulation::ResultSubject pressed = of(-0.01, "1");
    EXPECT_EQ(subject_difference(pressed, of(-0.01, "1")), "");
    EXPECT_EQ(subject_difference(pressed, of(-0.01, "2")), "the stages");
    EXPECT_THAT(subject_difference(pressed, of(-0.02, "1")), HasSubstr("the stages"))
        << "the load case that the stage names has changed";
    const auto alone = simulate(strip(), named("tip", -0.01), {.model = "corotational"});
    EXPECT_EQ(subject_difference(pressed, *alone.subject), "the stages");
    EXPECT_NO_THROW(check_subject(pressed, "r.json"));
    simulation::ResultSubject broken = pressed;
    broken.stages_text = R"({"format": "fretwork/stages/1", "stages": []})";
    EXPECT_THAT(complaint_of([&] { check_subject(broken, "r.json"); }),
                testing::StartsWith("r.json: /subject/stages/stages: is empty"));
    broken = pressed;
    broken.stage_load_cases.push_back(R"({"format": "fretwork/load-case/1", "name": ""})");
    EXPECT_THAT(complaint_of([&] { check_subject(broken, "r.json"); }),
                testing::StartsWith("r.json: /subject/stage_load_cases/1/name: is empty"));
}

constexpr const char* kPress = R"({"format": "fretwork/stages/1", "stages": [
    {"name": "press", "loads": [{"load_case": "tip", "factor": 1}]}]})";
constexpr const char* kPressAndLetGo = R"({"format": "fretwork/stages/1", "stages": [
    {"name": "press", "loads": [{"load_case": "tip", "factor": 1}]},
    {"name": "off", "loads": [{"load_case": "tip", "factor": 0}]}]})";

/// Bends the strip upwards, so that its tiles turn by more than the limit themselves.
LoadCase far() {
    return named("tip", -1.0);
}

TEST(StagesDoubt, IsSmallWhereTheSurfaceIsBentALittle) {
    const auto result = staged({named("tip", -0.02)}, kPress);
    ASSERT_TRUE(result.model_doubt);
    EXPECT_LE(result.solution.iterations, kDoubtfulIterations);
    EXPECT_FALSE(is_doubtful(result));
    EXPECT_FALSE(result.model_error);
    EXPECT_EQ(model_warning(result), "");
}

TEST(StagesDoubt, IsLargeWhereTheSurfaceHasJumped) {
    SurfaceResult result;
    result.model_doubt = ModelDoubt{};
    result.subject.emplace().stages_text = kPress;
    result.load_steps.resize(2);
    EXPECT_FALSE(is_doubtful(result));
    result.load_steps.front().stability_losses.emplace_back();
    EXPECT_TRUE(is_doubtful(result)) << "also in an earlier stage";
    result.load_steps.front().stability_losses.clear();
    result.load_steps.front().iterations = kDoubtfulIterations + 1;
    EXPECT_TRUE(is_doubtful(result)) << "a path that nearly branches takes many solves";
}

/// Within half of the truth, as for results without stages.
TEST(StagesError, IsThatAgainstTheFullModelAtTheEndOfAnyStage) {
    const std::vector<LoadCase> cases = {far()};
    const auto result = staged(cases, kPressAndLetGo);
    ASSERT_TRUE(is_doubtful(result));
    ASSERT_TRUE(result.model_error);
    const std::vector<LoadStage> stages = parse_stages(kPressAndLetGo, "stages.json");
    const auto full = simulate_stages(strip(), {cases.front(), cases, stages}, {.model = "full"});
    SurfaceResult pressed = result;
    pressed.solution = result.load_steps.front();
    SurfaceResult truth = full;
    truth.solution = full.load_steps.front();
    const Comparison comparison = compare(truth, pressed);
    const auto expect_near = [](double estimate, double error) { EXPECT_NEAR(estimate, error, 0.5 * error); };
    expect_near(result.model_error->largest, comparison.max_translation_error / comparison.max_displacement);
    expect_near(result.model_error->mean, comparison.mean_translation_error / comparison.max_displacement);
    expect_near(result.model_error->relative_l2, comparison.relative_l2_error);
    const auto largest = [](const SurfaceResult& of) {
        return most_stressed(beam_table(strip(), of), 1).front().largest_von_mises();
    };
    ASSERT_TRUE(result.model_error->largest_stress);
    const double error = std::abs(largest(pressed) - largest(truth)) / largest(truth);
    EXPECT_NEAR(*result.model_error->largest_stress, error, 0.5 * error + 1e-3);
}

/// Without the load nothing is left, neither of the displacements nor of their error.
TEST(StagesError, OfAStageThatEndsAtRestIsNotARatioOfRoundings) {
    const auto pressed = staged({far()}, kPress);
    const auto let_go = staged({far()}, kPressAndLetGo);
    ASSERT_TRUE(pressed.model_error && let_go.model_error);
    EXPECT_NEAR(let_go.model_error->largest, pressed.model_error->largest, 1e-6);
    EXPECT_NEAR(let_go.model_error->mean, pressed.model_error->mean, 1e-6);
    EXPECT_NEAR(let_go.model_error->relative_l2, pressed.model_error->relative_l2, 1e-6);
}

TEST(StagesError, IsEstimatedIfAskedForAndOfCorotationalTilesAlone) {
    const std::vector<LoadCase> cases = {named("tip", -0.01)};
    const std::vector<LoadStage> stages = parse_stages(kPress, "stages.json");
    const StagePlan plan{cases.front(), cases, stages};
    const auto result =
        simulate_stages(strip(), plan, {.model = "corotational", .estimate_model_error = true});
    ASSERT_TRUE(result.model_error);
    EXPECT_GT(result.model_error->largest, 0.0);
    EXPECT_TRUE(result.buckled_tiles);
    for (const char* model : {"full", "mixed:0.1"})
        EXPECT_NE(complaint_of([&] {
                      (void)simulate_stages(strip(), plan, {.model = model, .estimate_model_error = true});
                  }),
                  "")
            << model;
}

simulation::SurfaceResult in_one_stage(const std::vector<LoadCase>& cases, const std::string& stage) {
    return staged(cases, (R"({"format": "fretwork/stages/1", "stages": [)" + stage + "]}").c_str());
}

LoadCase pulled(const char* name, double amount) {
    LoadCase load_case = named(name, 0.0);
    load_case.loads.clear();
    load_case.prescribed.push_back({NodesAtSide{Side::Right}, mechanics::Dof::uz, amount});
    return load_case;
}

/// A load case that prescribes displacements is moved by its factor, in a stage as alone.
TEST(Stages, TakePrescribedDisplacementsOfALoadCase) {
    const std::vector<LoadCase> cases = {pulled("lift", 0.01)};
    const auto result =
        in_one_stage(cases, R"({"name": "up", "loads": [{"load_case": "lift", "factor": 2}]})");
    ASSERT_TRUE(result.solution.converged());
    const auto alone = simulate(strip(), pulled("lift", 0.02), {.model = "corotational"});
    EXPECT_LT((result.solution.displacements - alone.solution.displacements).norm(),
              1e-6 * alone.solution.displacements.norm());  // two paths to one equilibrium
}

/// Whatever a stage says of a component itself goes before the load cases that it names.
TEST(Stages, PreferWhatTheySayThemselvesToWhatTheirLoadCasesPrescribe) {
    const std::vector<LoadCase> cases = {pulled("lift", 0.01)};
    const auto result = in_one_stage(cases, R"({"name": "up", "loads": [{"load_case": "lift", "factor": 1}],
        "prescribed": [{"side": "right", "uz": 0.005}]})");
    const auto alone = simulate(strip(), pulled("lift", 0.005), {.model = "corotational"});
    EXPECT_LT((result.solution.displacements - alone.solution.displacements).norm(),
              1e-6 * alone.solution.displacements.norm());
    const auto let_go = staged(cases, R"({"format": "fretwork/stages/1", "stages": [
        {"name": "up", "loads": [{"load_case": "lift", "factor": 1}]},
        {"name": "off", "loads": [{"load_case": "lift", "factor": 0}],
                        "free": [{"side": "right", "fixed": ["uz"]}]}]})");
    ASSERT_TRUE(let_go.solution.converged());
    EXPECT_LT(let_go.solution.displacements.norm(), 1e-6 * alone.solution.displacements.norm());
}

/// Contradictions, and changes that change nothing.
TEST(Stages, RefuseEntriesThatContradictEachOther) {
    const std::vector<LoadCase> cases = {named("tip", -0.01), pulled("lift", 0.01), pulled("raise", 0.02)};
    const auto complaint = [&](const std::string& stage) {
        return complaint_of([&] { (void)in_one_stage(cases, stage); });
    };
    EXPECT_THAT(complaint(R"({"name": "a", "loads": [{"load_case": "tip", "factor": 1},
                                                     {"load_case": "tip", "factor": 2}]})"),
                HasSubstr("/stages/0/loads/1/load_case: is \"tip\", which this load stage names already"));
    EXPECT_THAT(complaint(R"({"name": "a", "loads": [{"load_case": "lift", "factor": 1},
                                                     {"load_case": "raise", "factor": 1}]})"),
                testing::StartsWith("load stage 'a': /loads/1: gives uz of node "));
    EXPECT_THAT(complaint(R"({"name": "a", "prescribed": [{"side": "right", "uz": 0.01}],
                              "keep": [{"side": "right", "fixed": ["uz"]}]})"),
                testing::AllOf(testing::StartsWith("load stage 'a': /prescribed/0: uz of node "),
                               HasSubstr("is also in \"keep\"")));
    EXPECT_THAT(complaint(R"({"name": "a", "prescribed": [{"side": "right", "uz": 0.01},
                                                          {"side": "right", "uz": 0.02}]})"),
                testing::StartsWith("load stage 'a': /prescribed/1: gives uz of node "));
    // An entry of the file may give several components.
    EXPECT_THAT(complaint(R"({"name": "a", "prescribed": [{"side": "right", "uy": 0, "uz": 0.01},
                                                          {"side": "right", "uz": 0.02}]})"),
                testing::StartsWith("load stage 'a': /prescribed/1: gives uz of node "));
    EXPECT_THAT(complaint(R"({"name": "a", "free": [{"side": "right", "fixed": ["uz"]}]})"),
                HasSubstr("/stages/0/free: releases nothing"));
    EXPECT_THAT(complaint(R"({"name": "a", "loads": [{"load_case": "tip", "factor": 1}],
                              "free": [{"side": "left", "fixed": ["uz"]}]})"),
                testing::StartsWith("load stage 'a': /free/0: releases nothing"));
    EXPECT_THAT(complaint(R"({"name": "a", "keep": [{"nodes": [100000], "fixed": ["uz"]}]})"),
                testing::StartsWith("load stage 'a': /keep/0: "));
}

/// Stages that no file has had.
TEST(Stages, NameALoadCaseOnce) {
    const std::vector<LoadCase> cases = {named("tip", -0.01)};
    const std::vector<LoadStage> stages = {{.name = "a", .loads = {{"tip", 1.0}, {"tip", 2.0}}}};
    EXPECT_EQ(complaint_of([&] {
                  check_stages(strip(), {cases.front(), cases, stages});
              }),
              "load stage 'a': /loads/1: names the load case 'tip' a second time");
}

TEST(Stages, OneThatChangesNothingIsRefusedBeforeTheWork) {
    const std::vector<LoadCase> cases = {named("tip", -0.01)};
    std::vector<LoadStage> stages(2);
    stages[0].name = "press";
    stages[0].loads = {{"tip", 1.0}};
    stages[1].name = "hold";
    EXPECT_THAT(complaint_of([&] {
                    (void)simulate_stages(strip(), {cases.front(), cases, stages}, {.model = "corotational"});
                }),
                testing::StartsWith("load stage 'hold': changes nothing"));
}

TEST(Stages, RefuseEntriesThatSelectNothing) {
    const std::vector<LoadCase> cases = {named("tip", -0.01)};
    const auto complaint = [&](const LoadStage& stage) {
        const std::vector<LoadStage> stages = {stage};
        return complaint_of([&] {
            (void)simulate_stages(strip(), {cases.front(), cases, stages}, {.model = "corotational"});
        });
    };
    LoadStage keeping;
    keeping.name = "a";
    keeping.keep = {{NodesById{}, mechanics::DofSet::all()}};
    EXPECT_THAT(complaint(keeping),
                testing::StartsWith("load stage 'a': /keep/0: selects no interface node"));
    LoadStage pushing;
    pushing.name = "a";
    pushing.prescribed = {{NodesNearest{}, mechanics::Dof::uz, 0.01}};
    EXPECT_THAT(complaint(pushing),
                testing::StartsWith("load stage 'a': /prescribed/0: selects no interface node"));
}

TEST(Stages, ASupportThatWasMovedIsNotReleased) {
    const std::vector<LoadCase> cases = {named("tip", -0.01)};
    EXPECT_THAT(complaint_of([&] {
                    (void)staged(cases, R"({"format": "fretwork/stages/1", "stages": [
        {"name": "push", "prescribed": [{"side": "left", "uz": 0.001}]},
        {"name": "off", "free": [{"side": "left", "fixed": ["uz"]}]}]})");
                }),
                testing::AllOf(testing::StartsWith("load stage 'off': /free/0: uz of node "),
                               HasSubstr("is a support of the load case 'tip'")));
}

/// Supports that move a surface as a rigid body leave no forces but rounding: later stages begin there.
TEST(Stages, BeginAndEndWhereSupportsHaveMovedTheSurfaceRigidly) {
    const std::vector<LoadCase> cases = {named("tip", -0.01)};
    const auto result = staged(cases, R"({"format": "fretwork/stages/1", "stages": [
        {"name": "lift", "prescribed": [{"side": "left", "uz": 0.01}, {"side": "right", "uz": 0.01}]},
        {"name": "hold", "keep": [{"side": "right", "fixed": ["uz"]}]},
        {"name": "let go", "free": [{"side": "right", "fixed": ["uz"]}]},
        {"name": "press", "loads": [{"load_case": "tip", "factor": 1}]},
        {"name": "off", "loads": [{"load_case": "tip", "factor": 0}]}]})");
    ASSERT_EQ(result.load_steps.size(), 5U);
    for (const auto& step : result.load_steps) ASSERT_TRUE(step.converged());
    const auto alone = simulate(strip(), cases.front(), {.model = "corotational"}).solution.displacements;
    mechanics::NodeValues lift = mechanics::NodeValues::Zero(alone.rows(), alone.cols());
    lift.col(2).setConstant(0.01);
    const auto expect_lifted = [&](std::size_t stage, const mechanics::NodeValues& bent) {
        EXPECT_LT((result.load_steps[stage].displacements - lift - bent).norm(), 1e-6 * alone.norm());
    };
    for (const std::size_t stage : {0, 1, 2, 4}) expect_lifted(stage, 0.0 * alone);
    expect_lifted(3, alone);
}

TEST(Stages, NoneIsRefused) {
    const std::vector<LoadCase> cases = {named("tip", -0.01)};
    EXPECT_THAT(complaint_of([&] {
                    (void)simulate_stages(strip(), {cases.front(), cases, {}}, {.model = "corotational"});
                }),
                HasSubstr("no load stage"));
}

}  // namespace THIS_TEST
}  // namespace fretwork::simulation
