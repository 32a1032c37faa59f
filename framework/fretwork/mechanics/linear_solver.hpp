// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/control.hpp>
#include <fretwork/mechanics/assembly.hpp>
#include <fretwork/mechanics/results/solution.hpp>

#include <memory>

namespace fretwork::mechanics {

/// Options of the linear solve.
struct LinearOptions {
    int threads = 1;          ///< 0: one for each processor. The number does not change a bit of a result.
    base::Control control{};  ///< how the caller follows and stops the work
};

/// The effect of an update on the factors.
enum class FactorChange {
    Kept,     ///< the factors stay; an earlier correction is dropped if no element differs from the
              ///< factorized ones
    Updated,  ///< the factors get a low-rank correction for the elements that differ from the factorized ones
    Refactorized,  ///< all factors are recomputed, with the same bits as in a new solver
};

/// The linear equilibrium K d = F of a structure at rest. K is factorized once, so each further load costs a
/// back-substitution.
///
/// A flat structure whose elements decouple is solved as two problems of three dofs at each node: in plane
/// (ux uy rz) and out of plane (uz rx ry). The factorization is a multifrontal L D L^T, ordered by the graph
/// of nodes, not of dofs.
class LinearSolver {
  public:
    /// Throws NumericalError that names a node if the structure can move without strain in spite of its
    /// supports.
    explicit LinearSolver(const Assembly& assembly, const LinearOptions& options = {});
    LinearSolver(LinearSolver&&) noexcept;
    LinearSolver& operator=(LinearSolver&&) noexcept;
    ~LinearSolver();

    /// Solve under the assembly's own loads, or under other loads (one row for each node of the assembly).
    /// Several threads may solve at once.
    ///
    /// The solution is refined as long as that reduces the residual, and the best iterate is returned. It has
    /// converged if its residual is below 1e-9; a residual up to 1e-4 counts, too, if the rounding of the
    /// displacements explains it. Throws NumericalError if a displacement is too large for a number; Stopped.
    [[nodiscard]] Solution solve(const base::Control& control = {}) const;
    /// Solve under other loads with the factors that are there.
    [[nodiscard]] Solution solve(const NodeValues& loads, const base::Control& control = {}) const;

    /// Solve K x = g with all held dofs at zero, for several right sides at once. Adjoint gradients need it.
    /// Columns have 6 rows for each node of the assembly, in the order of Dof. Forces on held dofs are
    /// ignored. Throws NumericalError if a displacement is too large for a number; Stopped.
    [[nodiscard]] Eigen::MatrixXd solve_free(const Eigen::MatrixXd& right_sides,
                                             const base::Control& control = {}) const;

    /// Switch to another assembly, and recompute only what its differences require:
    /// - loads and prescribed values: nothing;
    /// - elements replaced by others of the same nodes, listed in any order: a low-rank correction if a count
    ///   of multiplications says that it costs less than new factors, and no place becomes 1e5 times softer
    ///   or stiffer; else new factors. A solve with corrected factors takes up to four times as long
    ///   (README.md, bench/edits_bench);
    /// - supports: everything but the elimination order;
    /// - anything else: everything.
    /// Elements are compared by address. The solver shares them and keeps no reference to the assembly
    /// itself. Throws as the constructor, and then leaves the solver as it was.
    FactorChange update(const Assembly& assembly, const base::Control& control = {});

  private:
    class Impl;
    std::unique_ptr<Impl> impl_;
};

/// Solve the linear equilibrium of an assembly once. Throws as LinearSolver.
Solution solve_linear(const Assembly& assembly, const LinearOptions& options = {});

}  // namespace fretwork::mechanics
