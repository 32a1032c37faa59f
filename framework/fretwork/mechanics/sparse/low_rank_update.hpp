// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/sparse/ldlt.hpp>

#include <Eigen/Cholesky>

#include <optional>
#include <span>
#include <vector>

namespace fretwork::mechanics::sparse {

/// A change of a matrix: a symmetric matrix that is added to the rows and columns of some equations.
struct MatrixChange {
    std::vector<int> equations;
    Eigen::MatrixXd values;
};

/// Solves with the changed matrix A + sum of E C E^T by the factors of A (Sherman, Morrison, Woodbury). C is
/// the matrix of a change, and E maps the rows of C to the change's equations.
///
/// The eigenvectors of each C, scaled by A's diagonal, give C = P P^T - M M^T. Eigenvalues of the size of
/// rounding are dropped. With U = (E P, E M), S = diag(I, -I) and y = A^-1 b, the solution is x = y - A^-1 U
/// (S + U^T A^-1 U)^-1 U^T y. The inner matrix S + U^T A^-1 U is eliminated by blocks. The eigenvalues of its
/// block for P are the ratios by which A becomes stiffer. The elimination of this block leaves a Schur
/// complement; the negated eigenvalues of this complement are the ratios by which A becomes softer.
class LowRankUpdate {
  public:
    /// Make the update. Pre: `factors` are those of a positive definite A. Returns nothing if the changed
    /// matrix is not positive definite, or if it is 1e5 times softer or stiffer than A somewhere: about a
    /// third of the digits would be lost. The pivots of the inner matrix measure this ratio, because pivots
    /// are cheaper than eigenvalues and no farther from one. Throws Stopped.
    static std::optional<LowRankUpdate> make(const Ldlt& factors, std::vector<MatrixChange> changes,
                                             const base::Control& control = {});

    /// The number of multiplications of make() for changes of these equations, plus the number by which one
    /// solve() exceeds a solution with A. `equations` lists each equation once for each change.
    static double work(const Ldlt& factors, std::span<const int> equations);

    /// Solve with the changed matrix, in place, by two solutions with A. `factors` must be those of make().
    /// Throws Stopped.
    void solve(const Ldlt& factors, Eigen::VectorXd& right_side, const base::Control& control = {}) const;
    void solve(const Ldlt& factors, Eigen::MatrixXd& right_sides, const base::Control& control = {}) const;

    /// Compute y += (sum of E C E^T) x.
    void add_product(const Eigen::VectorXd& x, Eigen::VectorXd& y) const;

  private:
    /// The factors P and M of a change C = P P^T - M M^T.
    struct Modes {
        Eigen::MatrixXd plus, minus;
    };
    LowRankUpdate() = default;
    static Modes modes_of(const Ldlt& factors, const MatrixChange& change);
    [[nodiscard]] Eigen::Index rank() const { return plus_ + minus_; }
    /// Call body(change, columns of P or M, position of the columns in U) for the P and M of every change.
    template <class Body>
    void for_each_block(const Body& body) const;
    [[nodiscard]] bool factorize_inner(const Eigen::MatrixXd& form);
    [[nodiscard]] Eigen::MatrixXd inner_solution(const Eigen::MatrixXd& projected) const;

    std::vector<MatrixChange> changes_;
    std::vector<Modes> modes_;  ///< P and M of each change
    Eigen::Index plus_ = 0;     ///< number of columns of all P, which come first in U
    Eigen::Index minus_ = 0;    ///< number of columns of all M
    /// The factors of the inner matrix's blocks for stiffer modes and for softer modes; none for an empty
    /// block.
    std::optional<Eigen::LLT<Eigen::MatrixXd>> stiffer_, softer_;
    Eigen::MatrixXd coupling_;  ///< M^T A^-1 P
};

}  // namespace fretwork::mechanics::sparse
