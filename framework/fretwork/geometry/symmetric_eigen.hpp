// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace fretwork::geometry {

/// The eigenvalues of a symmetric matrix, ascending, and its unit eigenvectors, one in each column.
struct SymmetricEigen {
    Eigen::VectorXd values;   ///< ascending
    Eigen::MatrixXd vectors;  ///< one column of length 1 for each eigenvalue
};

/// Decompose a symmetric matrix. Only its lower triangle is read. Eigen's solver is slow to compile, so it is
/// compiled once, for all callers.
SymmetricEigen symmetric_eigen(const Eigen::MatrixXd& matrix);

}  // namespace fretwork::geometry
