// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/sparse/dense_ldlt.hpp>
#include <fretwork/mechanics/sparse/elimination_plan.hpp>
#include <fretwork/mechanics/sparse/large_array.hpp>

#include <span>
#include <vector>

namespace fretwork::mechanics::sparse {

/// The factorization A = L D L^T of a symmetric sparse matrix in the order of its layout, whose pivots count
/// its negative eigenvalues (Sylvester). Multifrontal: the columns of each supernode are eliminated in one
/// small dense matrix, which hands what is left of it to its parent's. Pivots are not exchanged: of the
/// tangents of structures only those next to a singular one suffer from that, and a vanishing pivot says so.
class Ldlt {
  public:
    /// @param threads  that factorize() uses where it is worth them; 0: all there are. They change no bit.
    explicit Ldlt(const SystemLayout& layout, int threads = 1);

    /// How a factorization ended.
    struct Outcome {
        int negative_pivots = 0;
        int zero_pivot =
            -1;  ///< an equation whose pivot vanishes against its diagonal; -1: none, and solve() works
        bool has_weak_pivot = false;  ///< one is so small beside its diagonal that it may be rounding
        [[nodiscard]] bool positive_definite() const { return zero_pivot < 0 && negative_pivots == 0; }
    };
    /// Factorize the matrix with these values, in the order of the layout's rows. Throws NumericalError if a
    /// diagonal entry is not finite.
    Outcome factorize(std::span<const double> values);

    /// Solve with the last factorization, in place, for one right side or several columns of them.
    void solve(Eigen::VectorXd& right_side);
    void solve(Eigen::MatrixXd& right_sides);

  private:
    void eliminate_task(std::size_t task, std::span<const double> values);
    void assemble(const Supernode& supernode, std::span<const double> values, const Front& front) const;
    void add_to_panel(std::size_t child, const Front& front) const;
    void add_to_rest(std::size_t child, const Front& front) const;
    void solve_column(double* x);
    [[nodiscard]] Front front_of(std::size_t supernode) const;

    const SystemLayout* layout_;
    int threads_;
    SupernodeTree tree_;
    EliminationPlan plan_;
    LargeArray factor_;             ///< the panels, one after the other
    LargeArray storage_;            ///< what waits for its parent
    std::vector<int> entry_place_;  ///< of the layout's entries: rows of their columns in the fronts
    std::vector<double> diagonal_;
    std::vector<Pivots> pivots_;  ///< of each supernode
    std::vector<double> scratch_;
};

/// y += A x for the symmetric matrix of a layout.
void add_product(const SystemLayout& layout, std::span<const double> values, const Eigen::VectorXd& x,
                 Eigen::VectorXd& y);

}  // namespace fretwork::mechanics::sparse
