// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/paths/equilibrium.hpp>
#include <fretwork/mechanics/paths/equilibrium_tangent.hpp>

#include <functional>
#include <memory>

namespace fretwork::mechanics {

/// Where an equilibrium was looked for from.
enum class StartingPoint {
    Rest,            ///< by the path from rest
    LastEquilibrium  ///< by continuation from the equilibrium before
};

/// Whether the stability of an equilibrium is decided. That takes a factorization, which a small change of
/// the loads does not need otherwise.
enum class StabilityCheck {
    Made,
    Left  ///< Solution::stability is None: for loads that are dragged. The next solution that is checked
          ///< makes it up: an equilibrium that has lost its stability meanwhile is looked for from rest
};

/// Receives the first iterate on the way to an equilibrium: the prediction of the tangent in the last
/// equilibrium. It is no equilibrium (Solution::converged is false, and it has no reactions), but is near one
/// after small edits. Not called if there is no last equilibrium to go on from.
using FirstIterate = std::function<void(const Solution&)>;

/// The nonlinear equilibrium of a structure under its full load, found again and again between edits: the
/// large displacements' counterpart of LinearSolver.
///
/// An answer from the last equilibrium is one to which the structure goes from there as the edit is made,
/// without losing its stability on the way: the last and the new equilibrium are stable, and the move between
/// them is of the size that the tangents at both ends account for. Where that cannot be said, the path is
/// followed from rest. Both answers agree wherever the loads have one stable equilibrium only. Where they
/// have several (a buckled surface, a snapped dome), an answer from the last equilibrium stays with the one
/// that the edits led to, and the path from rest may lead to another.
class EquilibriumSolver {
  public:
    /// Branch::Stable and located critical loads ask for the path: they are always answered from rest. Throws
    /// InputError as EquilibriumOptions::validate.
    explicit EquilibriumSolver(const EquilibriumOptions& options = {});
    EquilibriumSolver(EquilibriumSolver&&) noexcept;
    EquilibriumSolver& operator=(EquilibriumSolver&&) noexcept;
    ~EquilibriumSolver();

    /// The equilibrium of an assembly under its full load. The work depends on how the assembly differs from
    /// the last one (elements are compared by address):
    /// - loads and prescribed values: iterations with the last factors, and new ones once or twice;
    /// - elements replaced by others of the same nodes: the same after new factors in the last equilibrium;
    /// - supports: a new order of elimination and new factors, in the last equilibrium;
    /// - other nodes, or a last solution that had not converged or was not stable: everything, from rest.
    /// Throws as follow_load_path; then the next call starts from rest. A stop on the way from the last
    /// equilibrium keeps that one to go on from.
    ///
    /// @param first_iterate  may be empty
    Solution solve(const Assembly& assembly, const base::Control& control = {},
                   StabilityCheck check = StabilityCheck::Made, const FirstIterate& first_iterate = {});

    /// Stability of the last solution.
    [[nodiscard]] StartingPoint starting_point() const;

    /// The derivatives at the last equilibrium; valid until the next solve(). Throws InputError if the last
    /// solution has not converged, NumericalError if the tangent is singular there, and Stopped.
    [[nodiscard]] EquilibriumTangent tangent(const base::Control& control = {});

  private:
    class Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace fretwork::mechanics
