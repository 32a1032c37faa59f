// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/design/search/uniform_guess.hpp>

#include <Eigen/Dense>

#include <algorithm>

namespace fretwork::design::detail {

Eigen::MatrixXd leading_coordinates(const Eigen::MatrixXd& logarithms) {
    const Eigen::MatrixXd centred = logarithms.colwise() - logarithms.rowwise().mean();
    // The products of columns are used, because there are fewer patterns than entries of a stiffness.
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> modes(centred.transpose() * centred);
    const Eigen::Index count = std::min<Eigen::Index>(3, logarithms.cols());
    const Eigen::VectorXd lengths = modes.eigenvalues().tail(count).cwiseMax(0.0).cwiseSqrt().reverse();
    return lengths.asDiagonal() * modes.eigenvectors().rightCols(count).rowwise().reverse().transpose();
}

Eigen::VectorXd prediction_weights(const Eigen::MatrixXd& known, const Eigen::VectorXd& place) {
    const Eigen::Index count = known.cols();
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(count + 2, count + 2);
    Eigen::VectorXd right(count + 2);
    for (Eigen::Index i = 0; i < count; ++i) {
        matrix.col(i).head(count) = -(known.colwise() - known.col(i)).colwise().norm().transpose();
        matrix(i, count) = matrix(count, i) = 1.0;
        matrix(i, count + 1) = matrix(count + 1, i) = known(0, i);
    }
    right.head(count) = -(known.colwise() - place).colwise().norm().transpose();
    right[count] = 1.0;
    right[count + 1] = place[0];
    return Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd>(matrix).solve(right).head(count);
}

}  // namespace fretwork::design::detail
