// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace fretwork::geometry {

/// Eigenvalues of a symmetric matrix, ascending, and its unit eigenvectors, one a column.
struct SymmetricEigen {
    Eigen::VectorXd values;
    Eigen::MatrixXd vectors;
};

/// Decomposes a symmetric matrix; only its lower triangle is read. One source compiles Eigen's solver, which
/// takes the compiler four seconds each time.
SymmetricEigen symmetric_eigen(const Eigen::MatrixXd& matrix);

}  // namespace fretwork::geometry
