// SPDX-License-Identifier: GPL-3.0-or-later
#include "honeycomb.hpp"
#include "support.hpp"

#include <fretwork/simulation/simulate.hpp>
#include <fretwork/simulation/stages.hpp>

namespace fretwork::simulation {
namespace {

using mechanics::Snaps;
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

mechanics::Result staged(const std::vector<LoadCase>& cases, const char* stages) {
    return simulate_stages(strip(), cases.front(), cases, parse_stages(stages, "stages.json"),
                           {.model = "corotational"}, Snaps::Stop);
}

/// What a stage applies is what the load case alone would.
TEST(Stages, ApplyALoadCaseWhateverItIsCalled) {
    const std::vector<LoadCase> cases = {named("tip", -0.01), named("stage", -0.02)};
    const auto result = staged(cases, R"({"format": "fretwork/stages/1", "stages": [
        {"name": "press", "loads": [{"load_case": "stage", "factor": 1}]}]})");
    ASSERT_TRUE(result.solution.converged());
    const auto alone = simulate(strip(), cases[1], {.model = "corotational"});
    EXPECT_LT((result.solution.displacements - alone.solution.displacements).norm(),
              1e-6 * alone.solution.displacements.norm());  // two paths to one equilibrium
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

TEST(Stages, NoneIsRefused) {
    const std::vector<LoadCase> cases = {named("tip", -0.01)};
    EXPECT_THAT(complaint_of([&] {
                    (void)simulate_stages(strip(), cases.front(), cases, {}, {.model = "corotational"},
                                          Snaps::Stop);
                }),
                HasSubstr("no stage"));
}

}  // namespace
}  // namespace fretwork::simulation
