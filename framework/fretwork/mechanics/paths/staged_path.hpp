// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/paths/equilibrium.hpp>

#include <memory>

namespace fretwork::mechanics {

/// The supports and loads of a structure at the end of a stage.
struct StageTarget {
    std::vector<Support> supports;
    std::vector<PrescribedDisplacement> prescribed;
    NodeValues loads;  ///< one row for each node of the assembly
};

/// Stages of loading, one after the other: each begins in the equilibrium at the end of the stage before.
/// During a stage loads and prescribed values change linearly to those of the target; a newly prescribed
/// component starts from its present value, and the reaction on a released component is reduced to zero.
///
/// Steps are followed by Newton's method, and halved where that fails. An unstable equilibrium is left along
/// a descent direction. If no step is short enough, the structure goes downhill from its last equilibrium
/// with Branch::Snapping; otherwise the stage ends at that limit load. Such places are
/// Solution::stability_losses, with the share of the stage as the load factor and the node that moves
/// farthest.
class StagedPath {
  public:
    /// The supports, prescribed values and loads of the assembly are left aside. Throws InputError as
    /// EquilibriumOptions::validate, whose location of critical loads does not count here.
    explicit StagedPath(Assembly assembly, const EquilibriumOptions& options = {});
    StagedPath(StagedPath&&) noexcept;
    StagedPath& operator=(StagedPath&&) noexcept;
    ~StagedPath();

    /// Solution::load_factor is the share of the stage that was reached. One that has not converged ends the
    /// stages: the next call goes on from its last equilibrium. Throws NumericalError if the structure, as
    /// held, can move without strain at rest; Stopped.
    Solution advance(const StageTarget& target);

  private:
    class Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace fretwork::mechanics
