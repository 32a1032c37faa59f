// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/paths/equilibrium.hpp>

#include <memory>

namespace fretwork::mechanics {

/// What holds a structure and acts on it at the end of a stage.
struct StageTarget {
    std::vector<Support> supports;
    std::vector<PrescribedDisplacement> prescribed;
    NodeValues loads;  ///< one row for each node of the assembly
};

/// Stages of loading, one after the other: each begins in the equilibrium that the stage before has led to.
/// On the way loads and prescribed values go evenly from what they are to those of the target; a component
/// that is newly prescribed goes from where it is, and one that is freed is let go by what held it.
///
/// Steps are followed by Newton's method, and halved where that fails. An equilibrium that is not stable is
/// left downhill. Where no step is short enough, the structure goes downhill from its last equilibrium with
/// Branch::Snapping; else the stage ends at that limit load. Such places are Solution::stability_losses, with
/// the share of the stage as the load factor and the node that moves farthest.
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
