// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/control.hpp>
#include <fretwork/mechanics/assembly.hpp>
#include <fretwork/mechanics/results/solution.hpp>

#include <memory>

namespace fretwork::mechanics {

/// Options of the linear solve.
struct LinearOptions {
    int threads = 1;  ///< 0: all there are. They change no bit of a result.
    base::Control control{};
};

/// The effect of an update of a structure on its factors.
enum class FactorChange {
    Kept,     ///< nothing; a correction that they had is dropped if no element differs from those factorized
    Updated,  ///< a correction of low rank for the elements that differ from those factorized
    Refactorized,  ///< all factors are computed again, with the bits of a new solver's
};

/// The linear equilibrium K d = F of a structure at rest, factorized once: another load is a
/// back-substitution.
///
/// A flat structure whose elements decouple is solved as two problems of three dofs a node: in plane (ux uy
/// rz) and out of plane (uz rx ry). The node graph is ordered, not the dof graph; multifrontal
/// L D L^T.
class LinearSolver {
  public:
    /// Throws NumericalError that names a node if the structure, as held, can move without strain.
    explicit LinearSolver(const Assembly& assembly, const LinearOptions& options = {});
    LinearSolver(LinearSolver&&) noexcept;
    LinearSolver& operator=(LinearSolver&&) noexcept;
    ~LinearSolver();

    /// The same structure under its own loads, or under others (one row for each node of the assembly).
    /// Several threads may solve at once.
    ///
    /// The solution is refined while that helps, and the best iterate is the solution. It has converged if
    /// its residual is below 1e-9, or no more than the rounding of the displacements explains, and 1e-4 at
    /// most. Throws NumericalError if a displacement is too large for a number; Stopped.
    [[nodiscard]] Solution solve(const base::Control& control = {}) const;
    [[nodiscard]] Solution solve(const NodeValues& loads, const base::Control& control = {}) const;

    /// Solve K x = g with all held dofs at zero, for several right sides at once: what adjoint gradients
    /// need. Columns have 6 rows for each node of the assembly, in the order of Dof. Forces on held dofs are
    /// left aside. Throws NumericalError if a displacement is too large for a number; Stopped.
    [[nodiscard]] Eigen::MatrixXd solve_free(const Eigen::MatrixXd& right_sides,
                                             const base::Control& control = {}) const;

    /// Go over to another assembly, and do only the work that its differences ask for:
    /// - loads and prescribed values: none;
    /// - elements replaced by others of the same nodes, listed in whatever order: a correction of low rank
    /// where a count of
    ///   multiplications says that it costs less than new factors, unless the structure becomes 1e5 times
    ///   softer or stiffer somewhere. The border is at about 4 replaced tiles of 500 and 8 of 2,000
    ///   (README.md, bench/edits_bench). While factors are corrected, a solve takes up to four times as long;
    /// - supports: everything but the elimination order;
    /// - anything else: everything.
    /// Elements are compared by address; nothing of the assembly is borrowed but they. Throws as the
    /// constructor, and then nothing has changed.
    FactorChange update(const Assembly& assembly, const base::Control& control = {});

  private:
    class Impl;
    std::unique_ptr<Impl> impl_;
};

/// Solve once. Throws as LinearSolver.
Solution solve_linear(const Assembly& assembly, const LinearOptions& options = {});

}  // namespace fretwork::mechanics
