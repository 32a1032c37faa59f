// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/task.hpp>
#include <fretwork/mechanics/sparse/ldlt.hpp>
#include <fretwork/mechanics/sparse/system_layout.hpp>

#include <Eigen/Core>

#include <span>
#include <vector>

namespace fretwork::mechanics::structure {

/// A search for eigenvalues mu and eigenvectors x of A x = mu K x by subspace iteration with factors of K -
/// shift A. K is a structure's stiffness at rest, and A is any symmetric matrix of the same layout.
class SubspaceIteration {
  public:
    struct Pairs {
        Eigen::VectorXd values;
        Eigen::MatrixXd vectors;
    };

    struct Matrices {
        std::span<const double> stiffness;  ///< K, positive definite; must outlive the SubspaceIteration
        std::vector<double> operand;        ///< A
    };

    /// @param factors  the factors of K
    /// @param control  progress counts iterations
    SubspaceIteration(const sparse::SystemLayout& layout, Matrices matrices, sparse::Ldlt factors,
                      const base::Control& control = {});

    /// The `count` eigenvalues with the largest absolute values, largest first; fewer if A has a lower rank.
    /// Throws NumericalError if they do not settle, or if the structure is nearly a mechanism; Stopped.
    Pairs largest(int count);

    /// The `count` largest positive eigenvalues, largest first. Eigenvalues below 1e-8 of the largest
    /// absolute value are left out, so there may be fewer than `count`. No eigenvalue is missed, because
    /// Sylvester's law of inertia counts them: the number of negative pivots of K - lambda A is the number of
    /// eigenvalues mu > 1 / lambda. Throws as largest().
    Pairs largest_positive(int count);

  private:
    struct Slice;
    [[nodiscard]] double find_start();
    [[nodiscard]] int count_below(double& factor);
    void append_slice(const Slice& slice, Pairs& found);
    void factorize_shifted(double shift);
    [[nodiscard]] Eigen::MatrixXd times(std::span<const double> matrix, const Eigen::MatrixXd& vectors) const;
    [[nodiscard]] Pairs step(const Eigen::MatrixXd& basis, double shift);
    [[nodiscard]] Pairs project(Eigen::MatrixXd vectors, double shift) const;

    const sparse::SystemLayout& layout_;
    std::span<const double> stiffness_;
    std::vector<double> operand_;
    sparse::Ldlt factors_;
    sparse::Ldlt::Outcome outcome_;
    base::Control control_;
    base::Task task_;
    std::size_t iterations_ = 0;
};

}  // namespace fretwork::mechanics::structure
