// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/control.hpp>
#include <fretwork/mechanics/assembly.hpp>
#include <fretwork/mechanics/results/solution.hpp>

#include <memory>

namespace fretwork::mechanics {

/// Options of the linear solve.
struct LinearOptions {
    /// Number of threads; 0: one for each processor. The result is bitwise the same for every number of
    /// threads.
    int threads = 1;
    base::Control control{};  ///< progress and stop
};

/// How an update has changed the factors.
enum class FactorChange {
    /// The factors stay. An earlier correction is dropped if all elements are those of the factors.
    Kept,
    /// The factors get a low-rank correction for elements that differ from those of the factors.
    Updated,
    Refactorized,  ///< all factors are recomputed, with the same bits as in a new solver
};

/// The linear equilibrium K d = F of a structure at rest. K is factorized once, and each solution costs a
/// back-substitution.
///
/// A structure with all nodes at one z, and with elements that decouple, is solved as two problems of three
/// dofs at each node: in plane (ux uy rz) and out of plane (uz rx ry). The factorization is a multifrontal
/// L D L^T. The order of elimination comes from the graph of nodes, not of dofs.
class LinearSolver {
  public:
    /// Factorize the stiffness of an assembly. Throws NumericalError if the structure can move without strain
    /// in spite of its supports (kinds NothingHeld, PartNotHeld and MovesFreely), or if a stiffness is not
    /// finite; Stopped.
    explicit LinearSolver(const Assembly& assembly, const LinearOptions& options = {});
    LinearSolver(LinearSolver&&) noexcept;
    LinearSolver& operator=(LinearSolver&&) noexcept;
    ~LinearSolver();

    /// Solve under the assembly's own loads. Several threads may solve at once.
    ///
    /// The solution is refined at most three times, until its residual is below 1e-9 or is no longer halved;
    /// with corrected factors, at least once. The best iterate is returned. The solution has converged if its
    /// residual is below 1e-9, or if its residual is below 1e-4 and the rounding of the displacements
    /// explains it. The residual is set to 0 if there are no loads and rounding explains all forces. Throws
    /// NumericalError if a displacement is too large for a number; Stopped.
    [[nodiscard]] Solution solve(const base::Control& control = {}) const;
    /// Solve under other loads, one row for each node of the assembly. Throws as the function above.
    [[nodiscard]] Solution solve(const NodeValues& loads, const base::Control& control = {}) const;

    /// Solve K x = g with all held dofs at zero, for several right sides g at once, such as adjoint
    /// gradients. Each column has 6 rows for each node of the assembly, in the order of Dof. Forces on held
    /// dofs are ignored. Throws NumericalError if a displacement is too large for a number; Stopped.
    [[nodiscard]] Eigen::MatrixXd solve_free(const Eigen::MatrixXd& right_sides,
                                             const base::Control& control = {}) const;

    /// Switch to another assembly, and recompute only the data that depend on the difference:
    /// - if loads or prescribed values differ: nothing;
    /// - if elements are replaced by others of the same nodes, listed in any order: a low-rank correction or
    ///   new factors. The correction is chosen if it needs less than half the multiplications, and if no
    ///   place becomes 1e5 times softer or stiffer. A solution with corrected factors takes up to four times
    ///   as long (docs/numbers/mechanics.md, bench/edits_bench);
    /// - if supports differ: everything but the elimination order;
    /// - if anything else differs: everything.
    /// Elements are compared by address. The solver shares the elements and keeps no reference to the
    /// assembly itself. Throws as the constructor; the solver then stays as it was.
    FactorChange update(const Assembly& assembly, const base::Control& control = {});

  private:
    class Impl;
    std::unique_ptr<Impl> impl_;
};

/// Solve the linear equilibrium of an assembly once. Throws as LinearSolver.
Solution solve_linear(const Assembly& assembly, const LinearOptions& options = {});

}  // namespace fretwork::mechanics
