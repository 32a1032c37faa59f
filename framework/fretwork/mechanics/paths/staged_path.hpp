// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/paths/equilibrium.hpp>

#include <memory>

namespace fretwork::mechanics {

/// The supports and loads of a structure at the end of a load stage.
struct StageTarget {
    std::vector<Support> supports;
    std::vector<PrescribedDisplacement> prescribed;
    NodeValues loads;  ///< one row for each node of the assembly
};

/// Follows load stages one after the other. Each begins at the equilibrium in which the one before ended.
/// During a load stage, loads and prescribed values change linearly to those of the target. A newly
/// prescribed component starts from its present value; the reaction on a released component is reduced to
/// zero.
///
/// Newton's method solves each step; a step that fails is halved. An unstable equilibrium is left along a
/// descent direction. If no step is short enough, the load stage ends at this limit load; with
/// Branch::Snapping, the structure goes downhill from its last equilibrium instead. Each such place is one of
/// Solution::stability_losses: its load factor is the share of the load stage, its node the one that moves
/// farthest.
class StagedPath {
  public:
    /// Ignores the supports, prescribed values and loads of the assembly, and
    /// EquilibriumOptions::locate_critical_loads. Throws InputError as EquilibriumOptions::validate.
    explicit StagedPath(Assembly assembly, const EquilibriumOptions& options = {});
    StagedPath(StagedPath&&) noexcept;
    StagedPath& operator=(StagedPath&&) noexcept;
    ~StagedPath();

    /// Follow one load stage. Solution::load_factor is the share of it that was reached. If the solution has
    /// not converged, the next call goes on from its last equilibrium. Throws NumericalError if the
    /// structure, as held, can move without strain at rest; Stopped.
    Solution advance(const StageTarget& target);

  private:
    class Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace fretwork::mechanics
