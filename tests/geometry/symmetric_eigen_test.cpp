// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/geometry/symmetric_eigen.hpp>

#include <gtest/gtest.h>

namespace fretwork::geometry {
namespace THIS_TEST {

TEST(SymmetricEigen, GivesTheMatrixBackFromAscendingValuesAndUnitVectors) {
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(7, 7);
    for (int i = 0; i < 7; ++i) {
        for (int j = 0; j < 7; ++j) matrix(i, j) = 1.0 / (1.0 + i + j);  // Hilbert's
    }
    const SymmetricEigen eigen = symmetric_eigen(matrix);
    for (int i = 1; i < 7; ++i) EXPECT_LT(eigen.values[i - 1], eigen.values[i]);
    const Eigen::MatrixXd again = eigen.vectors * eigen.values.asDiagonal() * eigen.vectors.transpose();
    const Eigen::MatrixXd products = eigen.vectors.transpose() * eigen.vectors;
    EXPECT_LT((again - matrix).cwiseAbs().maxCoeff(), 1e-14);
    EXPECT_LT((products - Eigen::MatrixXd::Identity(7, 7)).cwiseAbs().maxCoeff(), 1e-14);
}

}  // namespace THIS_TEST
}  // namespace fretwork::geometry
