// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/sparse/dense_ldlt.hpp>
#include <fretwork/mechanics/sparse/elimination_plan.hpp>
#include <fretwork/mechanics/sparse/large_array.hpp>

#include <memory>
#include <span>
#include <vector>

namespace fretwork::mechanics::sparse {

/// The factorization A = L D L^T of a symmetric sparse matrix in the order of its layout. The number of
/// negative pivots is the number of negative eigenvalues (Sylvester). The method is multifrontal: the columns
/// of each supernode are eliminated in one small dense matrix, and its rest is added to the parent's matrix.
/// Pivots are not exchanged. For the tangent of a structure, this does harm only if the tangent is nearly
/// singular, which a vanishing pivot reveals.
class Ldlt {
  public:
    /// Analyse a layout, which must outlive the factorization. Throws Stopped.
    /// @param threads  number of threads that factorize() uses for large matrices; 0: one for each processor.
    /// The result is bitwise the same for every number of threads.
    explicit Ldlt(const SystemLayout& layout, int threads = 1, const base::Control& control = {});
    /// An empty factorization for another matrix of the same layout. Both factorizations share the analysis
    /// of the layout.
    [[nodiscard]] Ldlt another() const;

    /// The outcome of a factorization.
    struct Outcome {
        int negative_pivots = 0;
        /// Equation with a pivot that vanishes relative to its diagonal entry; -1: none, and solve() works.
        int zero_pivot = -1;
        /// True if a pivot is so small relative to its diagonal entry that it may be rounding.
        bool has_weak_pivot = false;
        [[nodiscard]] bool positive_definite() const { return zero_pivot < 0 && negative_pivots == 0; }
    };
    /// Factorize the matrix with these values, in the order of the layout's rows. Throws NumericalError if a
    /// diagonal entry is not finite, and Stopped. After an error, no factors exist until the next
    /// factorization.
    Outcome factorize(std::span<const double> values, const base::Control& control = {});

    /// Solve with the last factorization, in place, for one right side or for a matrix of right sides, one in
    /// each column. Several threads may solve at once. Throws Stopped.
    void solve(Eigen::VectorXd& right_side, const base::Control& control = {}) const;
    void solve(Eigen::MatrixXd& right_sides, const base::Control& control = {}) const;

    /// The product U^T A^-1 U for a positive definite A and columns U that are zero except at `equations`.
    /// Only the supernodes from these equations up to the roots take part, so the product is far cheaper than
    /// a solution. Throws Stopped.
    [[nodiscard]] Eigen::MatrixXd inverse_form(Eigen::MatrixXd columns, std::span<const int> equations,
                                               const base::Control& control = {}) const;

    /// The blocks of A^-1 at some cliques. A clique is a list of equations that the layout couples with each
    /// other. Throws Stopped.
    [[nodiscard]] std::vector<Eigen::MatrixXd> inverse_blocks(std::span<const std::vector<int>> cliques,
                                                              const base::Control& control = {}) const;

    [[nodiscard]] int equations() const { return analysis_->layout->equations(); }
    /// The diagonal entry of A in an equation.
    [[nodiscard]] double diagonal(int equation) const { return diagonal_[equation]; }

    /// The numbers of multiplications of factorize(), of solve() for one column, and of inverse_form().
    [[nodiscard]] double factorization_work() const;
    [[nodiscard]] double solution_work() const;
    [[nodiscard]] double inverse_form_work(std::span<const int> equations, Eigen::Index columns) const;

  private:
    /// The data that depend only on the layout.
    struct Analysis {
        const SystemLayout* layout;
        int threads;
        SupernodeTree tree;
        EliminationPlan plan;
        std::vector<int> entry_place;  ///< for each entry of the layout, its row in its front
    };
    static std::shared_ptr<const Analysis> analyse(const SystemLayout& layout, int threads,
                                                   const base::Control& control);
    explicit Ldlt(std::shared_ptr<const Analysis> analysis);

    void eliminate_task(std::size_t task, std::span<const double> values, const base::Control& control);
    void assemble(const Supernode& supernode, std::span<const double> values, const Front& front) const;
    [[nodiscard]] Remainder remainder_of(std::size_t supernode) const;
    /// Columns stored one after the other, each with one number for every equation.
    struct Columns {
        double* values;
        Eigen::Index count;
    };
    void solve_columns(Columns columns, const base::Control& control) const;
    /// The columns of a substitution, and the numbers that supernodes pass to their parents, stored by
    /// plan.updates for each column.
    struct Substitution {
        Columns columns;
        std::vector<double> updates;
        const base::Control& control;
        [[nodiscard]] double* update(std::size_t start, Eigen::Index column, std::size_t size) {
            return updates.data() + static_cast<std::size_t>(column) * size + start;
        }
    };
    [[nodiscard]] Substitution begin(Columns columns, const base::Control& control) const;
    [[nodiscard]] std::span<const int> children_of(std::size_t supernode) const;
    void substitute_forward_in(std::size_t supernode, std::span<const int> children,
                               Substitution& substitution) const;
    void substitute_back_in(std::size_t supernode, Substitution& substitution) const;
    /// The supernodes from these equations up to the roots, ascending.
    [[nodiscard]] std::vector<std::size_t> path_from(std::span<const int> equations) const;
    [[nodiscard]] Front front_of(std::size_t supernode) const;

    std::shared_ptr<const Analysis> analysis_;
    LargeArray factor_;   ///< panels of all supernodes, one after the other
    LargeArray storage_;  ///< rests that wait for the elimination of their parents
    std::vector<double> diagonal_;
    std::vector<Pivots> pivots_;  ///< pivots of each supernode
};

/// Compute y += A x, where A is the symmetric matrix with these values.
void add_product(const SystemLayout& layout, std::span<const double> values, const Eigen::VectorXd& x,
                 Eigen::VectorXd& y);

}  // namespace fretwork::mechanics::sparse
