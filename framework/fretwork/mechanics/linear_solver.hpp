// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/assembly.hpp>
#include <fretwork/mechanics/solution.hpp>

#include <memory>

namespace fretwork::mechanics {

/// Options of the linear solve.
struct LinearOptions {
    int threads = 1;  ///< 0: all there are. They change no bit of a result.
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

    /// The same structure under its own loads, or under others (one row for each node of the assembly). Not
    /// from several threads at once: the vectors of a solve are kept for the next one.
    [[nodiscard]] Solution solve() const;
    [[nodiscard]] Solution solve(const NodeValues& loads) const;

    /// The same nodes, connections and supports with elements of other stiffness: the symbolic analysis is
    /// kept.
    void refactorize(const Assembly& assembly);

  private:
    class Impl;
    std::unique_ptr<Impl> impl_;
};

/// Solve once. Throws as LinearSolver.
Solution solve_linear(const Assembly& assembly, const LinearOptions& options = {});

}  // namespace fretwork::mechanics
