// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/geometry/symmetric_eigen.hpp>

#include <Eigen/Eigenvalues>

namespace fretwork::geometry {

SymmetricEigen symmetric_eigen(const Eigen::MatrixXd& matrix) {
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(matrix);
    return {solver.eigenvalues(), solver.eigenvectors()};
}

}  // namespace fretwork::geometry
