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

/// Whether to check the stability of an equilibrium. The check needs a factorization; a solution after a
/// small change of the loads needs none otherwise.
enum class StabilityCheck {
    Made,  ///< the stability is checked if EquilibriumOptions::classify_stability is true
    /// The stability is not checked, for example while a user drags a load; Solution::stability is None. If
    /// the next check finds an unstable equilibrium, that solution is computed from rest.
    Skipped
};

/// A receiver of the first iterate on the way to an equilibrium: the prediction by the tangent at the last
/// equilibrium. After small edits, it is close to the new equilibrium, but is not one: Solution::converged()
/// is false, and there are no reactions. The function is not called on the way from rest. If the way from the
/// last equilibrium was given up after the call, starting_point() is Rest.
using FirstIterate = std::function<void(const Solution&)>;

/// Solves for the nonlinear equilibrium of a structure under its full load after each of many edits: the
/// counterpart of LinearSolver for large displacements. Only one thread at a time may use it.
///
/// A solution from the last equilibrium is accepted only if the edit seems to keep the structure stable: both
/// equilibria are stable, and the tangents at both ends predict the move between them. Otherwise the path is
/// followed from rest. Both ways give the same equilibrium if the structure has only one stable equilibrium
/// under its loads. If it has several (a buckled surface, a snapped dome), a solution from the last
/// equilibrium stays on the branch that the edits have reached, and the path from rest may lead to another
/// branch.
class EquilibriumSolver {
  public:
    /// Make a solver. Every solution starts from rest if the options ask for another branch than
    /// Branch::Primary, or for located critical loads: both need the whole path. Throws InputError as
    /// EquilibriumOptions::validate().
    explicit EquilibriumSolver(const EquilibriumOptions& options = {});
    EquilibriumSolver(EquilibriumSolver&&) noexcept;
    EquilibriumSolver& operator=(EquilibriumSolver&&) noexcept;
    ~EquilibriumSolver();

    /// The equilibrium of an assembly under its full load. The work depends on the difference from the last
    /// assembly (elements are compared by address):
    /// - if loads or prescribed displacements differ: iterations with the last factors, and new factors once
    ///   or twice;
    /// - if prescribed rotations differ, or elements are replaced by others of the same nodes in the same
    ///   order: new factors at the last equilibrium, then the same work;
    /// - if supports differ, or elements have other nodes: a new order and new factors at the last
    ///   equilibrium; a start from rest if new supports hold components far from their values;
    /// - if nodes differ, or if the last solution had not converged or was not stable: everything, from rest.
    /// Throws as follow_load_path(); after an error, the next call starts from rest. After a stop on the way
    /// from the last equilibrium, the next call starts from that last equilibrium.
    ///
    /// @param first_iterate  receiver of the first iterate; may be empty
    Solution solve(const Assembly& assembly, const base::Control& control = {},
                   StabilityCheck check = StabilityCheck::Made, const FirstIterate& first_iterate = {});

    /// The state from which the last solution was found.
    [[nodiscard]] StartingPoint starting_point() const;

    /// The derivatives at the last equilibrium; valid until the next solve(). Throws InputError if the last
    /// solution has not converged, NumericalError if the tangent is singular, and Stopped.
    [[nodiscard]] EquilibriumTangent tangent(const base::Control& control = {});

  private:
    class Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace fretwork::mechanics
