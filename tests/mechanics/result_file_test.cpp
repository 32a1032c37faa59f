// SPDX-License-Identifier: GPL-3.0-or-later
#include "support.hpp"

#include <fretwork/base/error.hpp>
#include <fretwork/base/files/file.hpp>
#include <fretwork/mechanics/results/result_file.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <limits>

namespace fretwork::mechanics {
namespace THIS_TEST {

using testing::HasSubstr;

Solution some_solution() {
    Solution solution;
    solution.load_factor = 0.7;
    solution.termination = Termination::LimitLoad;
    solution.stable = false;
    solution.stability = StabilityTest::SymmetricPart;
    solution.displacements = NodeValues::Constant(2, kDofsPerNode, 1.0 / 3.0);
    solution.reactions = NodeValues::Constant(2, kDofsPerNode, -1e-17);
    solution.energy = 2.5;
    solution.residual = 3e-10;
    solution.iterations = 17;
    return solution;
}

Result some_result() {
    Result result;
    result.solver = "newton";
    result.nodes = {{4, {0.1, 0.2, 0.3}, true}, {9, {0.0, -0.2, 0.3}, false}};
    result.solution = some_solution();
    result.load_steps = {some_solution(), some_solution()};
    result.load_steps[0].termination = Termination::Converged;
    result.vibration_modes = {{12.5, NodeValues::Constant(2, kDofsPerNode, 0.1)}};
    result.buckling_modes = {{2.5, NodeValues::Constant(2, kDofsPerNode, 0.2)}};
    result.solution.stability_losses = {{0.4, NodeIndex(1), Dof::ry, true},
                                        {0.6, NodeIndex(0), Dof::uz, false}};
    result.discretization_error = DiscretizationError{1e-5, 2.0 / 3.0, 0.1, true};
    result.seconds = 0.25;
    return result;
}

class ResultFile : public testing::Test {
  protected:
    std::string complaint(const std::string& piece, const std::string& by) {
        write_result(some_result(), path_);
        std::string text = base::read_text_file(path_);
        const auto place = text.find(piece);
        EXPECT_NE(place, std::string::npos) << piece;
        std::ofstream(path_) << text.replace(place, piece.size(), by);
        try {
            read_result(path_);
        } catch (const base::InputError& error) {
            return error.what();
        }
        return "";
    }
    test::TemporaryFolder folder_;
    std::filesystem::path path_ = folder_.path() / "result.json";
};

TEST_F(ResultFile, WrittenResultIsReadBackExactly) {
    const Result written = some_result();
    write_result(written, path_);
    const Result read = read_result(path_);
    EXPECT_EQ(read.solver, written.solver);
    ASSERT_EQ(read.nodes.size(), 2u);
    EXPECT_EQ(read.nodes[0].id, 4);
    EXPECT_TRUE(read.nodes[0].is_interface);
    EXPECT_EQ(read.nodes[1].rest_position, written.nodes[1].rest_position);
    EXPECT_EQ(read.discretization_error, written.discretization_error);
    EXPECT_EQ(read.solution.displacements, written.solution.displacements);
    EXPECT_EQ(read.solution.reactions, written.solution.reactions);
    EXPECT_EQ(read.solution.termination, Termination::LimitLoad);
    EXPECT_EQ(read.solution.stability, StabilityTest::SymmetricPart);
    EXPECT_FALSE(read.solution.stable);
    EXPECT_EQ(read.solution.iterations, 17);
    ASSERT_EQ(read.load_steps.size(), 2u);
    EXPECT_EQ(read.load_steps[0].termination, Termination::Converged);
    EXPECT_EQ(read.load_steps[1].energy, 2.5);
    ASSERT_EQ(read.vibration_modes.size(), 1u);
    EXPECT_EQ(read.vibration_modes[0].value, 12.5);
    EXPECT_EQ(read.vibration_modes[0].shape, written.vibration_modes[0].shape);
    ASSERT_EQ(read.buckling_modes.size(), 1u);
    EXPECT_EQ(read.buckling_modes[0].value, 2.5);
    EXPECT_EQ(read.buckling_modes[0].shape, written.buckling_modes[0].shape);
    ASSERT_EQ(read.solution.stability_losses.size(), 2u);
    EXPECT_EQ(read.solution.stability_losses[0].load_factor, 0.4);
    EXPECT_EQ(read.solution.stability_losses[0].node, NodeIndex(1));
    EXPECT_EQ(read.solution.stability_losses[0].dof, Dof::ry);
    EXPECT_TRUE(read.solution.stability_losses[0].pushed);
    EXPECT_FALSE(read.solution.stability_losses[1].pushed);
    EXPECT_TRUE(read.load_steps[0].stability_losses.empty());
}

// Modes of nodes that hardly move have large rotations, and stiff frames have reactions beyond all loads.
TEST_F(ResultFile, LargeModesAndReactionsAreReadBack) {
    Result written = some_result();
    written.vibration_modes[0].shape(1, 3) = -714162679.3;
    written.buckling_modes[0].shape(0, 5) = 1e21;
    written.solution.reactions(0, 0) = -2e18;
    written.solution.reactions(1, 4) = 2e30;
    written.load_steps.back().reactions = written.solution.reactions;
    const Result read = parse_result(result_text(written), "somewhere");
    EXPECT_EQ(read.vibration_modes[0].shape, written.vibration_modes[0].shape);
    EXPECT_EQ(read.buckling_modes[0].shape, written.buckling_modes[0].shape);
    EXPECT_EQ(read.solution.reactions, written.solution.reactions);
}

TEST_F(ResultFile, TextIsReadAsTheFileIs) {
    const std::string text = result_text(some_result());
    EXPECT_EQ(result_text(parse_result(text, "somewhere")), text);
    try {
        parse_result("{}", "somewhere");
        FAIL();
    } catch (const base::InputError& error) {
        EXPECT_THAT(error.what(), testing::StartsWith("somewhere"));
    }
}

TEST_F(ResultFile, NumberThatIsNotFiniteIsNotWritten) {
    Result result = some_result();
    write_result(result, path_);
    const std::string before = base::read_text_file(path_);
    result.solution.displacements(1, 2) = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW(write_result(result, path_), base::NumericalError);
    EXPECT_EQ(base::read_text_file(path_), before);
}

TEST_F(ResultFile, BadFilesAreRefusedWithTheirPlace) {
    EXPECT_THAT(complaint("\"converged\": false", "\"converged\": true"), HasSubstr("/converged"));
    EXPECT_THAT(complaint("limit-load", "limit-loaded"), HasSubstr("/termination"));
    EXPECT_THAT(complaint("\"symmetric-part\"", "\"guess\""), HasSubstr("/stability"));
    EXPECT_THAT(complaint("\"energy\"", "\"enrgy\""), HasSubstr("energy"));
    EXPECT_THAT(complaint("0.3333333333333333,", ""), HasSubstr("/displacements/0"));
    EXPECT_THAT(complaint("0.3333333333333333", "null"), HasSubstr("/displacements/0/0"));
    EXPECT_THAT(complaint("\"id\": 4", "\"id\": -4"), HasSubstr("/nodes/0/id"));
    EXPECT_THAT(complaint("}", ""), HasSubstr("line"));
}

TEST_F(ResultFile, ValuesThatNoSolverGivesAreRefusedWithTheirPlace) {
    EXPECT_THAT(complaint("\"newton\"", "\"newtn\""), HasSubstr("/solver: unknown solver 'newtn'"));
    EXPECT_THAT(complaint("\"residual\": 3e-10", "\"residual\": -3e-10"), HasSubstr("/residual"));
    EXPECT_THAT(complaint("\"seconds\": 0.25", "\"seconds\": -1"), HasSubstr("/seconds"));
    EXPECT_THAT(complaint("\"share\": 0.1", "\"share\": -0.1"), HasSubstr("/discretization_error/share"));
}

TEST_F(ResultFile, ValuesBeyondAllStructuresAreRefusedWithTheirPlace) {
    EXPECT_THAT(complaint("0.3333333333333333", "1e308"), HasSubstr("/displacements/0: has 1e+308"));
}

TEST_F(ResultFile, AnIdThatTwoNodesHaveIsRefused) {
    EXPECT_THAT(complaint("\"id\": 9", "\"id\": 4"),
                HasSubstr("/nodes/1/id: is 4, the id of a node before it"));
}

TEST_F(ResultFile, FormatsOfUnreleasedVersionsAreRefusedInWords) {
    EXPECT_THAT(
        complaint("fretwork/result/4", "fretwork/result/2"),
        HasSubstr("/format: is \"fretwork/result/2\", of an unreleased version: make the result again"));
}

TEST_F(ResultFile, KeysOfASurfaceAreRefused) {
    EXPECT_THAT(complaint("\"solver\"", "\"linear_range\""), HasSubstr("unknown key 'linear_range'"));
}

TEST_F(ResultFile, AnEndThatIsNotThatOfTheLoadStepsIsRefused) {
    EXPECT_THAT(complaint("\"load_factor\": 0.7", "\"load_factor\": 0.9"),
                HasSubstr("/load_factor: differs"));
    EXPECT_THAT(complaint("\"limit-load\"", "\"diverged\""), HasSubstr("/termination: differs"));
    EXPECT_THAT(complaint("0.3333333333333333", "0.4"), HasSubstr("/displacements: differs"));
}

TEST_F(ResultFile, MissingFileIsNamed) {
    EXPECT_THROW(read_result("/nowhere/result.json"), base::InputError);
}

}  // namespace THIS_TEST
}  // namespace fretwork::mechanics
