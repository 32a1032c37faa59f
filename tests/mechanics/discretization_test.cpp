// SPDX-License-Identifier: GPL-3.0-or-later
#include "sample.hpp"

#include <fretwork/base/error.hpp>
#include <fretwork/mechanics/discretization.hpp>

#include <gtest/gtest.h>

namespace fretwork::mechanics {
namespace THIS_TEST {

TEST(Discretization, EstimateIsCloseToTrueError) {
    const double factors[] = {0.5, 1.0};
    for (const Frame& frame : {sample::star(), sample::flat_wheel()}) {
        Frame loaded = frame;
        loaded.loads = {{NodeIndex(frame.nodes.size() == 4 ? 0 : 4), {0.3, -0.2, 1.0}}};
        const auto coarse = follow_load_path(assemble(loaded), factors);
        const auto exact = follow_load_path(assemble(refined(loaded, 16)), factors);
        const auto errors = estimate_discretization_error(loaded, factors, coarse);
        ASSERT_EQ(errors.size(), 2u);
        for (std::size_t i = 0; i < 2; ++i) {
            const NodeValues difference = coarse[i].displacements - exact[i].displacements;
            const double true_error = difference.leftCols<3>().rowwise().norm().maxCoeff();
            ASSERT_TRUE(errors[i].known);
            // Errors of either sign cancel by chance, more so on the coarsest divisions.
            EXPECT_GE(errors[i].displacement, 0.5 * true_error);
            EXPECT_LE(errors[i].displacement, 2.0 * true_error);
        }
    }
}

TEST(Discretization, EstimateFromHalfTheDivisionsIsNotTooSmall) {
    const double factors[] = {0.5, 1.0};
    for (const Frame& frame : {sample::star(), sample::flat_wheel()}) {
        Frame loaded = refined(frame, 4);
        loaded.loads = {{NodeIndex(frame.nodes.size() == 4 ? 0 : 4), {0.3, -0.2, 1.0}}};
        const auto solutions = follow_load_path(assemble(loaded), factors);
        const auto exact = follow_load_path(assemble(refined(loaded, 4)), factors);
        const auto errors = estimate_discretization_error(loaded, factors, solutions);
        for (std::size_t i = 0; i < 2; ++i) {
            const NodeValues difference = solutions[i].displacements - exact[i].displacements;
            const double true_error = difference.leftCols<3>().rowwise().norm().maxCoeff();
            ASSERT_TRUE(errors[i].known);
            EXPECT_GE(errors[i].displacement, true_error);
            // The order of these sections is four, with which the estimate is (2^4 - 1) / 3 = 5 times the
            // error; it may double, since coarse divisions are not yet where the order rules.
            EXPECT_LE(errors[i].displacement, 2.0 * 5.0 * true_error);
        }
    }
}

TEST(Discretization, UnconvergedSolutionHasNoEstimate) {
    const double factors[] = {1.0};
    auto solutions = follow_load_path(assemble(sample::star()), factors);
    solutions[0].termination = Termination::Diverged;
    EXPECT_FALSE(estimate_discretization_error(sample::star(), factors, solutions)[0].known);
}

TEST(Discretization, BadNumbersAreRefused) {
    const double factors[] = {1.0};
    EXPECT_THROW(refined(sample::star(), 0), base::InputError);
    const Frame divided = refined(sample::star(), 4);
    EXPECT_EQ(refined(divided, kMostDivisions / 4).beams[0].divisions, kMostDivisions);
    EXPECT_THROW(refined(divided, kMostDivisions / 4 + 1), base::InputError);
    EXPECT_THROW(refined(divided, (1 << 30) + 1), base::InputError);  // four times as much is no int
    EXPECT_THROW(estimate_discretization_error(sample::star(), factors, {}), base::InputError);
}

}  // namespace THIS_TEST
}  // namespace fretwork::mechanics
