// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/detail/system_layout.hpp>

#include <memory>
#include <span>

namespace fretwork::mechanics::detail {

/// The factorization of a symmetric sparse matrix in the order of its layout: supernodal Cholesky while it is
/// positive definite, else simplicial L D L^T, which counts the negative pivots. One thread.
class Cholesky {
  public:
    explicit Cholesky(const SystemLayout& layout);
    Cholesky(Cholesky&&) noexcept;
    Cholesky& operator=(Cholesky&&) noexcept;
    ~Cholesky();

    /// How a factorization ended.
    struct Outcome {
        int negative_pivots = 0;
        int zero_pivot =
            -1;  ///< an equation whose pivot vanishes against its diagonal; -1: none, and solve() works
        [[nodiscard]] bool positive_definite() const { return zero_pivot < 0 && negative_pivots == 0; }
    };
    /// Factorize the matrix with these values, in the order of the layout's rows. Throws NumericalError if
    /// one of them is not finite or memory runs out.
    Outcome factorize(std::span<const double> values);

    /// Solve with the last factorization, in place, for one right side or several columns of them.
    void solve(Eigen::VectorXd& right_side);
    void solve(Eigen::MatrixXd& right_sides);

  private:
    class Impl;
    std::unique_ptr<Impl> impl_;
};

/// y += A x for the symmetric matrix of a layout.
void add_product(const SystemLayout& layout, std::span<const double> values, const Eigen::VectorXd& x,
                 Eigen::VectorXd& y);

}  // namespace fretwork::mechanics::detail
