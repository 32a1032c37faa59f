// SPDX-License-Identifier: GPL-3.0-or-later
#include "fixtures.hpp"

#include <fretwork/base/error.hpp>
#include <fretwork/mechanics/linear_solver.hpp>
#include <fretwork/reduction/calibration/objective.hpp>
#include <fretwork/reduction/models/condensed_tile.hpp>

#include <Eigen/Eigenvalues>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace fretwork::reduction {
namespace THIS_TEST {

/// The stiffness of a pattern of the paper's layout and bars in a polygon.
Eigen::MatrixXd condensed_pattern(const pattern::Pattern& pattern, const geometry::Polygon& polygon) {
    const TileMaterial bars{paper_setting().section, paper_setting().material};
    return condensed_frame(pattern_frame(paper_layout(), pattern, polygon, bars),
                           static_cast<int>(polygon.size()));
}

TEST(CondensedTile, IsSymmetricSemidefiniteOfRank6nMinus6InAnyPolygon) {
    const geometry::Polygon irregular = {
        {0.0, 0.0}, {0.03, -0.004}, {0.05, 0.02}, {0.035, 0.045}, {-0.002, 0.03}};
    for (const auto& polygon :
         {geometry::regular_polygon(6, 0.026), geometry::regular_polygon(3, 0.03), irregular}) {
        const auto K = condensed_pattern(paper_pattern("0-1+1-6"), polygon);
        const auto size = static_cast<Eigen::Index>(6 * polygon.size());
        ASSERT_EQ(K.rows(), size);
        EXPECT_LT((K - K.transpose()).norm(), 1e-12 * K.norm());
        // Rotations in units of a bar's length, so that the eigenvalues can be compared.
        Eigen::VectorXd scale = Eigen::VectorXd::Ones(size);
        for (Eigen::Index i = 0; i < size; ++i) scale[i] = i % 6 < 3 ? 1.0 : 100.0;
        const Eigen::MatrixXd scaled = scale.asDiagonal() * K * scale.asDiagonal();
        const Eigen::VectorXd values = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(scaled).eigenvalues();
        EXPECT_LT(values.head(6).cwiseAbs().maxCoeff(), 1e-9 * values.maxCoeff());
        EXPECT_GT(values[6], 1e-7 * values.maxCoeff());
    }
}

TEST(CondensedTile, HasTheDisplacementsOfTheWholeFrameUnderEveryScenario) {
    const Setting setting = paper_setting();
    for (const char* id : {"0-1+1-6", "1-6+3-6"}) {
        const auto pattern = paper_pattern(id);
        const auto K = condensed_pattern(pattern, geometry::regular_polygon(6, setting.tile_side));
        const auto model = unit_displacements(K, setting);
        const auto tile = pattern_frame(paper_layout(), pattern, setting);
        for (std::size_t s = 0; s < 5; ++s) {
            Scenario unit = setting.scenarios[s];
            unit.max_magnitude = 1.0;
            const auto whole = mechanics::solve_linear(mechanics::assemble(scenario_frame(tile, unit)));
            EXPECT_LT(relative_difference(model[s], whole.displacements.topRows(6)), 1e-7)
                << id << " " << unit.name;
        }
    }
}

TEST(CondensedTile, ErrorTendsToZeroWithTheLoads) {
    Setting setting = paper_setting();
    const auto pattern = paper_pattern("0-1+1-6");
    const auto error_at = [&](double factor) {
        Setting scaled = setting;
        for (Scenario& scenario : scaled.scenarios) scenario.max_magnitude *= factor;
        const auto responses = compute_responses(paper_layout(), pattern, scaled);
        return calibrate(find_tile_model("condensed"), {paper_layout(), pattern, scaled, responses})
            .objective;
    };
    EXPECT_LT(error_at(1e-3), 1e-4 * error_at(1.0));
}

TEST(CondensedTile, RefusesAPatternThatLeavesInterfaceNodesFree) {
    try {
        (void)condensed_pattern(paper_pattern("0-1"), geometry::regular_polygon(6, 0.026));
        FAIL();
    } catch (const base::InputError& error) {
        EXPECT_THAT(error.what(), testing::HasSubstr("interface node 0"));
    }
}

TEST(UnitDisplacements, RefuseATileThatCanMoveFreely) {
    Setting setting = paper_setting();
    setting.scenarios[4].supports.clear();
    const auto K =
        condensed_pattern(paper_pattern("0-1+1-6"), geometry::regular_polygon(6, setting.tile_side));
    EXPECT_THROW((void)unit_displacements(K, setting), base::NumericalError);
}

}  // namespace THIS_TEST
}  // namespace fretwork::reduction
