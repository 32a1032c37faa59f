// SPDX-License-Identifier: GPL-3.0-or-later
#include "sample.hpp"

#include <fretwork/mechanics/elements/dense_products.hpp>

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include <limits>

namespace fretwork::mechanics::elements {
namespace THIS_TEST {

using Eigen::MatrixXd;
using Eigen::VectorXd;

MatrixXd random_matrix(Eigen::Index rows, Eigen::Index columns, std::uint64_t seed) {
    sample::Random random(seed);
    MatrixXd matrix(rows, columns);
    for (double& entry : matrix.reshaped()) entry = random.next();
    return matrix;
}

/// Every remainder of a strip of eight rows, and the sizes of tiles with three to seven sides.
constexpr Eigen::Index kSizes[] = {1, 2, 3, 4, 5, 6, 7, 8, 12, 18, 24, 30, 35, 36, 42, 71};
constexpr double kRounding = 200.0 * std::numeric_limits<double>::epsilon();

TEST(DenseProducts, AreThoseOfMatrixExpressions) {
    for (const Eigen::Index n : kSizes) {
        const MatrixXd a = random_matrix(n, n + 3, 1);
        const VectorXd x = random_matrix(n + 3, 1, 2);
        const VectorXd z = random_matrix(n, 1, 3);
        VectorXd y = VectorXd::Constant(n, std::numeric_limits<double>::quiet_NaN());  // does not count
        multiply_by_vector({a.data(), n, n + 3}, x.data(), y.data());
        EXPECT_LT((y - a * x).cwiseAbs().maxCoeff(), kRounding) << n;
        VectorXd w = x;
        add_transposed_product({a.data(), n, n + 3}, z.data(), w.data());
        EXPECT_LT((w - x - a.transpose() * z).cwiseAbs().maxCoeff(), kRounding) << n;
    }
}

TEST(DenseProducts, ThreeColumnsTimesASquareAreAddedOrReplace) {
    for (const Eigen::Index n : kSizes) {
        const MatrixXd a = random_matrix(n, 3, 1);
        const Eigen::Matrix3d m = random_matrix(3, 3, 2);
        const MatrixXd before = random_matrix(n, 3, 3);
        MatrixXd out = before;
        multiply_by_three({a.data(), n, 3}, m.data(), Sum::Add, out.data());
        EXPECT_LT((out - before - a * m).cwiseAbs().maxCoeff(), kRounding) << n;
        out.setConstant(std::numeric_limits<double>::quiet_NaN());
        multiply_by_three({a.data(), n, 3}, m.data(), Sum::Replace, out.data());
        EXPECT_LT((out - a * m).cwiseAbs().maxCoeff(), kRounding) << n;
    }
}

TEST(DenseProducts, SymmetricProductIsWrittenBelowTheDiagonal) {
    for (const Eigen::Index n : kSizes) {
        const MatrixXd a = random_matrix(n, 3, 1);
        const MatrixXd w = random_matrix(n, 3, 2);
        const MatrixXd before = random_matrix(n, n, 3);
        MatrixXd c = before;
        add_symmetric_product({a.data(), n, 3}, w.data(), c.data());
        const MatrixXd added = a * w.transpose() + w * a.transpose();
        const MatrixXd lower = added.triangularView<Eigen::Lower>();
        EXPECT_LT((c - before - lower).cwiseAbs().maxCoeff(), kRounding) << n;
    }
}

}  // namespace THIS_TEST
}  // namespace fretwork::mechanics::elements
