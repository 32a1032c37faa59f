// SPDX-License-Identifier: GPL-3.0-or-later
#include "sample.hpp"

#include <fretwork/base/error.hpp>
#include <fretwork/mechanics/nonlinear/nonlinear_system.hpp>
#include <fretwork/mechanics/sparse/ldlt.hpp>

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include <limits>

namespace fretwork::mechanics::sparse {
namespace THIS_TEST {

using Eigen::MatrixXd;
using Eigen::VectorXd;

VectorXd random_vector(Eigen::Index size, std::uint64_t seed) {
    sample::Random random(seed);
    VectorXd v(size);
    for (double& entry : v) entry = random.next();
    return v;
}

MatrixXd random_symmetric(Eigen::Index size, std::uint64_t seed) {
    sample::Random random(seed);
    MatrixXd a(size, size);
    for (double& entry : a.reshaped()) entry = random.next();
    return a + a.transpose().eval();
}

/// The textbook's elimination, one entry at a time.
void eliminate_plainly(MatrixXd& a, int width) {
    for (int j = 0; j < width; ++j) {
        const VectorXd column = a.col(j);
        for (Eigen::Index i = j + 1; i < a.rows(); ++i) a(i, j) /= column[j];
        for (Eigen::Index k = j + 1; k < a.rows(); ++k) {
            for (Eigen::Index i = k; i < a.rows(); ++i) a(i, k) -= a(i, j) * column[k];
        }
    }
}

TEST(DenseLdlt, EliminationMatchesTextbookForEveryShapeOfFront) {
    std::vector<double> scratch;
    for (const int width : {1, 3, 5, 6, 7, 12, 18, 31, 140}) {
        for (const int rows : {0, 1, 2, 3, 6, 9, 13, 24, 47}) {
            const int size = width + rows;
            MatrixXd a = random_symmetric(size, 7);
            // Far from singular, with pivots of both signs.
            for (int i = 0; i < size; ++i) a(i, i) += (i % 3 == 0 ? -3.0 : 3.0) * size;
            MatrixXd panel = a.leftCols(width);
            // Numbers that the rest held before do not count.
            MatrixXd rest = MatrixXd::Constant(rows, rows, std::numeric_limits<double>::quiet_NaN());
            a.bottomRightCorner(rows, rows).setZero();
            const VectorXd diagonal = a.diagonal();
            const Pivots pivots =
                eliminate({width, rows, panel.data(), rest.data()},
                          {{diagonal.data(), static_cast<std::size_t>(width)}, 1e-14}, scratch);
            eliminate_plainly(a, width);
            EXPECT_EQ(pivots.zero, -1);
            EXPECT_EQ(pivots.negative, (width + 2) / 3) << width;
            // Rounding grows with the number of products that are summed.
            const double tolerance = 1e-15 * size * size;
            for (int j = 0; j < size; ++j) {
                for (int i = j; i < size; ++i) {
                    const double found = j < width ? panel(i, j) : rest(i - width, j - width);
                    ASSERT_NEAR(found, a(i, j), tolerance) << width << " " << rows << " " << i << " " << j;
                }
            }
        }
    }
}

TEST(DenseLdlt, VanishingPivotStopsElimination) {
    MatrixXd a = MatrixXd::Identity(9, 9);
    a(7, 2) = 1.0;  // row 7 becomes row 2's multiple
    MatrixXd panel = a;
    std::vector<double> scratch;
    const std::vector<double> diagonal(9, 1.0);
    EXPECT_EQ(eliminate({9, 0, panel.data(), nullptr}, {diagonal, 1e-14}, scratch).zero, 7);
}

/// A matrix with the sparsity of a structure.
struct Sample {
    explicit Sample(const Frame& frame) : assembly(assemble(frame)), system(assembly) {
        system.evaluate(system.unknowns().rest(), 0.0);
        values.assign(system.tangent().begin(), system.tangent().end());
    }
    [[nodiscard]] MatrixXd dense() const {
        const auto& layout = system.unknowns().layout();
        MatrixXd a = MatrixXd::Zero(layout.equations(), layout.equations());
        for (int j = 0; j < layout.equations(); ++j) {
            for (int k = layout.column_start()[static_cast<std::size_t>(j)];
                 k < layout.column_start()[static_cast<std::size_t>(j) + 1]; ++k) {
                const int i = layout.row()[static_cast<std::size_t>(k)];
                a(i, j) = a(j, i) = values[static_cast<std::size_t>(k)];
            }
        }
        return a;
    }
    void shift(double share) {
        for (int j = 0; j < system.unknowns().layout().equations(); ++j)
            values[static_cast<std::size_t>(
                system.unknowns().layout().column_start()[static_cast<std::size_t>(j)])] *= 1.0 - share;
    }
    Assembly assembly;
    nonlinear::NonlinearSystem system;
    std::vector<double> values;
};

/// A grid of beams, clamped at one corner.
Frame grid(int size) {
    Frame frame;
    for (int i = 0; i < size; ++i) {
        for (int j = 0; j < size; ++j) frame.nodes.emplace_back(0.01 * i, 0.012 * j, 0.001 * i * j);
    }
    for (int i = 0; i < size; ++i) {
        for (int j = 0; j < size; ++j) {
            const int node = i * size + j;
            if (j + 1 < size) frame.beams.push_back(sample::beam_between(node, node + 1));
            if (i + 1 < size) frame.beams.push_back(sample::beam_between(node, node + size));
        }
    }
    sample::clamp(frame, 0);
    frame.supports.push_back({NodeIndex(size - 1), {{true, false, true, false, true, false}}});
    return frame;
}

TEST(Ldlt, SolvesWhatItFactorized) {
    for (const Frame& frame : {sample::star(), sample::flat_wheel(), grid(2), grid(9)}) {
        Sample sample(frame);
        Ldlt factors(sample.system.unknowns().layout());
        ASSERT_TRUE(factors.factorize(sample.values).positive_definite());
        const MatrixXd a = sample.dense();
        const VectorXd expected = random_vector(a.rows(), 3);
        VectorXd found = a * expected;
        factors.solve(found);
        // Displacements and rotations differ by a length, so the condition is large; the error in energy is
        // not.
        const VectorXd error = found - expected;
        EXPECT_LT(error.dot(a * error), 1e-18 * expected.dot(a * expected));
    }
}

TEST(Ldlt, SeveralRightSidesGiveTheBitsOfOne) {
    Sample sample(grid(4));
    Ldlt factors(sample.system.unknowns().layout());
    factors.factorize(sample.values);
    MatrixXd many(sample.system.unknowns().equations(), 3);
    for (int i = 0; i < 3; ++i) many.col(i) = random_vector(many.rows(), static_cast<std::uint64_t>(i) + 1);
    const MatrixXd right_sides = many;
    factors.solve(many);
    for (int i = 0; i < 3; ++i) {
        VectorXd one = right_sides.col(i);
        factors.solve(one);
        EXPECT_EQ((one - many.col(i)).norm(), 0.0);
    }
}

// Sylvester's law of inertia.
TEST(Ldlt, CountsTheNegativeEigenvalues) {
    for (const Frame& frame : {sample::star(), grid(3), grid(6)}) {
        for (const double share : {0.02, 0.2, 0.6, 1.5}) {
            Sample sample(frame);
            sample.shift(share);
            const MatrixXd a = sample.dense();
            const VectorXd eigenvalues = Eigen::SelfAdjointEigenSolver<MatrixXd>(a).eigenvalues();
            const auto expected = (eigenvalues.array() < 0.0).count();
            Ldlt factors(sample.system.unknowns().layout());
            const Ldlt::Outcome outcome = factors.factorize(sample.values);
            EXPECT_EQ(outcome.zero_pivot, -1);
            EXPECT_EQ(outcome.negative_pivots, expected) << share;
            EXPECT_EQ(outcome.positive_definite(), expected == 0);
        }
    }
}

TEST(Ldlt, ReportsVanishingPivotAndRefusesNaN) {
    Sample sample(grid(3));
    Ldlt factors(sample.system.unknowns().layout());
    std::vector<double> values(sample.values.size(), 0.0);
    EXPECT_EQ(factors.factorize(values).zero_pivot, 0);
    values[0] = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW(factors.factorize(values), base::NumericalError);
}

// The same numbers, again and again: nothing is left over from the factorization before.
TEST(Ldlt, RefactorizationIsIndependentOfTheLast) {
    Sample sample(grid(5));
    const VectorXd right_side = random_vector(sample.system.unknowns().equations(), 9);
    Ldlt fresh(sample.system.unknowns().layout());
    fresh.factorize(sample.values);
    VectorXd expected = right_side;
    fresh.solve(expected);
    Ldlt used(sample.system.unknowns().layout());
    std::vector<double> other = sample.values;
    for (double& value : other) value *= -3.0;
    used.factorize(other);
    used.factorize(sample.values);
    VectorXd found = right_side;
    used.solve(found);
    EXPECT_EQ((found - expected).norm(), 0.0);
}

}  // namespace THIS_TEST
}  // namespace fretwork::mechanics::sparse
