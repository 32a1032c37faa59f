// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/paths/equilibrium.hpp>
#include <fretwork/mechanics/paths/equilibrium_tangent.hpp>

#include <functional>
#include <memory>

namespace fretwork::mechanics {

/// The state from which an equilibrium was found.
enum class StartingPoint {
    Rest,            ///< rest, by following the load path
    LastEquilibrium  ///< the equilibrium before the edit, by continuation
};

/// The choice whether to check the stability of an equilibrium. The check takes a factorization, which a
/// small change of the loads would otherwise not need.
enum class StabilityCheck {
    Made,  ///< with a factorization
    Left  ///< no check, and Solution::stability is None: for loads that a user drags. If the next check finds
          ///< the equilibrium unstable, it is solved from rest
};

/// Receives the first iterate on the way to an equilibrium: the prediction by the tangent at the last
/// equilibrium. After small edits it is close to the new equilibrium, but it is not an equilibrium:
/// Solution::converged is false, and there are no reactions. It is not called if there is no last equilibrium
/// to continue from.
using FirstIterate = std::function<void(const Solution&)>;

/// Solves for the nonlinear equilibrium of a structure under its full load after each of many edits. It is
/// the counterpart of LinearSolver for large displacements.
///
/// A solution from the last equilibrium is accepted only if the structure keeps its stability while the edit
/// is made: both equilibria are stable, and the tangents at both ends account for the move between them.
/// Otherwise the path is followed from rest. Both ways agree if the loads have only one stable equilibrium.
/// If they have several (a buckled surface, a snapped dome), a solution from the last equilibrium stays on
/// the branch to which the edits led, and the path from rest may lead to another.
class EquilibriumSolver {
  public:
    /// Branch::Stable and located critical loads need the whole path, so they are always solved from rest.
    /// Throws InputError as EquilibriumOptions::validate.
    explicit EquilibriumSolver(const EquilibriumOptions& options = {});
    EquilibriumSolver(EquilibriumSolver&&) noexcept;
    EquilibriumSolver& operator=(EquilibriumSolver&&) noexcept;
    ~EquilibriumSolver();

    /// The equilibrium of an assembly under its full load. The work depends on how the assembly differs from
    /// the last one (elements are compared by address):
    /// - loads and prescribed values: iterations with the last factors, and new ones once or twice;
    /// - elements replaced by others of the same nodes: the same after new factors in the last equilibrium;
    /// - supports: a new order and new factors there; from rest where they are far from what they hold;
    /// - other nodes, or a last solution that had not converged or was not stable: everything, from rest.
    /// Throws as follow_load_path; then the next call starts from rest. After a stop on the way from the
    /// last equilibrium, the next call starts from that one.
    ///
    /// @param first_iterate  may be empty
    Solution solve(const Assembly& assembly, const base::Control& control = {},
                   StabilityCheck check = StabilityCheck::Made, const FirstIterate& first_iterate = {});

    /// The state from which the last solution was found.
    [[nodiscard]] StartingPoint starting_point() const;

    /// The derivatives at the last equilibrium; valid until the next solve(). Throws InputError if the last
    /// solution has not converged, NumericalError if the tangent is singular there, and Stopped.
    [[nodiscard]] EquilibriumTangent tangent(const base::Control& control = {});

  private:
    class Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace fretwork::mechanics
