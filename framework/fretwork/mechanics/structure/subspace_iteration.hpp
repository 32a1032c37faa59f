// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/task.hpp>
#include <fretwork/mechanics/sparse/ldlt.hpp>
#include <fretwork/mechanics/sparse/system_layout.hpp>

#include <Eigen/Core>

#include <span>
#include <vector>

namespace fretwork::mechanics::structure {

/// Eigenvalues mu of A x = mu K x, where K is a structure's stiffness at rest and A any symmetric matrix of
/// the same layout, with their vectors: subspace iteration with a factor of K - shift A.
class SubspaceIteration {
  public:
    struct Pairs {
        Eigen::VectorXd values;
        Eigen::MatrixXd vectors;
    };

    struct Matrices {
        std::span<const double> stiffness;  ///< K, positive definite; used while this lives
        std::vector<double> operand;        ///< A
    };

    /// @param factors  of K
    /// @param control  told the iterations
    SubspaceIteration(const sparse::SystemLayout& layout, Matrices matrices, sparse::Ldlt factors,
                      const base::Control& control = {});

    /// The `count` eigenvalues of largest size, largest first; fewer if A has a lower rank.
    Pairs largest(int count);

    /// The `count` largest of the positive eigenvalues, largest first; fewer if there are fewer that are more
    /// than 1e-8 of the largest size. They are counted by Sylvester's law of inertia (K - A / lambda has as
    /// many negative pivots as there are mu > 1 / lambda), so that none is passed over.
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
