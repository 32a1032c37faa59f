// SPDX-License-Identifier: GPL-3.0-or-later
#include "support.hpp"

#include <fretwork/base/error.hpp>
#include <fretwork/mechanics/results/result_file.hpp>
#include <fretwork/simulation/results/model_doubt.hpp>
#include <fretwork/simulation/results/surface_linear_range.hpp>
#include <fretwork/simulation/results/surface_result.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace fretwork::simulation {
namespace THIS_TEST {

using testing::HasSubstr;

SurfaceResult some_result() {
    SurfaceResult result;
    result.solver = "newton";
    result.nodes = {{0, {0.1, 0.2, 0.0}, true}, {1, {0.0, -0.2, 0.0}, false}};
    result.solution.displacements = mechanics::NodeValues::Constant(2, mechanics::kDofsPerNode, 1.0 / 3.0);
    result.solution.reactions = mechanics::NodeValues::Zero(2, mechanics::kDofsPerNode);
    result.subject = ResultSubject{.model = "mixed:0.1",
                                   .load_case = "a",
                                   .load_case_text = R"({"name":"a"})",
                                   .tessellation_hash = std::string(64, 'a'),
                                   .painting_hash = std::string(64, 'b'),
                                   .setting_hash = std::string(64, 'c'),
                                   .joints = reduction::Joints::Stiff,
                                   .full_tiles = {3, 14},
                                   .stages_text = R"({"stages":[{"name":"press"}]})",
                                   .stage_load_cases = {R"({"name":"a"})", R"({"name":"b"})"}};
    result.linear_range = mechanics::LinearRange{0.125, true};
    result.fit_error = 0.0625;
    result.model_doubt = ModelDoubt{0.2, 0.03};
    result.model_error = ModelError{0.001, 1.0 / 3.0, 0.02, 0.03};
    result.buckled_tiles = {5};
    result.seconds = 0.25;
    return result;
}

std::string complaint(const std::string& piece, const std::string& by) {
    std::string text = surface_result_text(some_result());
    const auto place = text.find(piece);
    EXPECT_NE(place, std::string::npos) << piece;
    try {
        parse_surface_result(text.replace(place, piece.size(), by), "result.json");
    } catch (const base::InputError& error) {
        return error.what();
    }
    return "";
}

TEST(SurfaceResult, AWrittenFileIsReadBackExactly) {
    const test::TemporaryFolder folder;
    const auto path = folder.path() / "result.json";
    const SurfaceResult written = some_result();
    write_surface_result(written, path);
    const SurfaceResult read = read_surface_result(path);
    EXPECT_EQ(read.subject, written.subject);
    EXPECT_EQ(read.linear_range, written.linear_range);
    EXPECT_EQ(read.fit_error, written.fit_error);
    EXPECT_EQ(read.model_doubt, written.model_doubt);
    EXPECT_EQ(read.model_error, written.model_error);
    EXPECT_EQ(read.buckled_tiles, written.buckled_tiles);
    EXPECT_EQ(read.solver, written.solver);
    EXPECT_EQ(read.solution.displacements, written.solution.displacements);
    EXPECT_TRUE(read.nodes[0].is_interface);
    EXPECT_EQ(surface_result_text(read), surface_result_text(written));
}

TEST(SurfaceResult, BadValuesAreRefusedWithTheirPlace) {
    EXPECT_THAT(complaint(std::string(64, 'b'), "b"), HasSubstr("/subject/painting"));
    EXPECT_THAT(complaint("[3, 14]", "[14, 3]"), HasSubstr("/subject/full_tiles"));
    EXPECT_THAT(complaint("\"load_factor\": 1.0", "\"load_factor\": 1.5"), HasSubstr("/load_factor: is 1.5"));
    EXPECT_THAT(complaint("\"mean\": 0.001", "\"mean\": -0.001"), HasSubstr("/model_error_estimate/mean"));
    EXPECT_THAT(
        complaint("\"full_share\": 0.0", "\"full_share\": 1.25"),
        HasSubstr("/model_error_estimate/full_share: is 1.25, where a share of the tiles from 0 to 1"));
    EXPECT_THAT(complaint("\"buckled_tiles\"", "\"broken_tiles\""), HasSubstr("unknown key 'broken_tiles'"));
}

TEST(SurfaceResult, AFrameIsNotTakenForASurface) {
    const std::string text = mechanics::result_text(some_result());
    try {
        parse_surface_result(text, "frame.json");
        FAIL();
    } catch (const base::InputError& error) {
        EXPECT_THAT(error.what(), HasSubstr("frame.json: /: is the result of a frame"));
    }
}

TEST(SurfaceResult, WithoutASubjectNothingIsWritten) {
    SurfaceResult result = some_result();
    result.subject.reset();
    EXPECT_THROW(surface_result_text(result), base::InputError);
}

TEST(SurfaceResult, AnEndThatIsNotTheAnswerIsWarnedOf) {
    SurfaceResult result = some_result();
    result.subject->stages_text.clear();
    EXPECT_EQ(path_warning(result), "");
    result.solution.stable = false;
    EXPECT_EQ(path_warning(result), "") << "no test, or an undecided one, says that it is unstable";
    result.solution.stability = mechanics::StabilityTest::Tangent;
    EXPECT_THAT(path_warning(result), HasSubstr("unstable"));
    result.solution.termination = mechanics::Termination::LimitLoad;
    result.solution.load_factor = 0.43;
    EXPECT_THAT(path_warning(result), HasSubstr("the path ends at 43 % of the load"));
    result.subject->stages_text = R"({"stages":[{"name":"press"}]})";
    result.load_steps.resize(1);
    EXPECT_THAT(path_warning(result), HasSubstr("load stage 1 ends at 43 % of the load"));
    result.solver = "relaxation";
    EXPECT_EQ(path_warning(result), "this is not an equilibrium");
}

TEST(SurfaceResult, HasAllOfItsWarningsInOneList) {
    SurfaceResult result = some_result();
    result.linear_range.reset();
    result.model_doubt.reset();
    result.model_error.reset();
    ASSERT_EQ(path_warning(result), "");
    EXPECT_THAT(result_warnings(result), testing::IsEmpty());
    result.solution.stable = false;
    result.solution.stability = mechanics::StabilityTest::Tangent;
    result.linear_range = mechanics::LinearRange{0.125, true};
    result.model_error = ModelError{.mean = 0.1, .largest = 0.2};
    EXPECT_THAT(result_warnings(result),
                testing::ElementsAre(path_warning(result), linear_doubt_text(result), model_warning(result)));
}

}  // namespace THIS_TEST
}  // namespace fretwork::simulation
