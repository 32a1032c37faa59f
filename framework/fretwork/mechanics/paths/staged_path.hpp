// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/paths/equilibrium.hpp>

#include <memory>

namespace fretwork::mechanics {

/// The supports and loads of a structure at the end of a load stage.
struct StageTarget {
    std::vector<Support> supports;  ///< components that are zero at the end of the load stage
    /// Components with given values at the end of the load stage.
    std::vector<PrescribedDisplacement> prescribed;
    NodeValues loads;  ///< loads, one row for each node of the assembly
};

/// A path of load stages. Each load stage begins at the equilibrium at the end of the previous one. Only one
/// thread at a time may use a path. During a load stage, loads and prescribed values change linearly to the
/// values of the target. A newly prescribed component starts from its present value; the reaction on a
/// released component is reduced to zero.
///
/// Each load stage is followed as in follow_load_path() with Branch::Stable: one load stage from rest gives
/// the equilibrium of that function. The structure leaves an unstable equilibrium along a descent direction.
/// If the release of a component has made the beginning of a load stage unstable, the structure descends
/// without the released reaction. A load stage ends at a limit load; with Branch::Snapping, the structure
/// descends in energy from its last equilibrium instead. Solution::stability_losses lists each unstable
/// equilibrium and each limit load. The load factor of an entry is the share of the load stage, and its node
/// is the node that moves farthest.
class StagedPath {
  public:
    /// Begin a path at rest. The supports (also those of hinges), prescribed values and loads of the assembly
    /// are ignored, and so is EquilibriumOptions::locate_critical_loads. Throws InputError as
    /// EquilibriumOptions::validate().
    explicit StagedPath(Assembly assembly, const EquilibriumOptions& options = {});
    StagedPath(StagedPath&&) noexcept;
    StagedPath& operator=(StagedPath&&) noexcept;
    ~StagedPath();

    /// Follow one load stage. Solution::load_factor is the share of the load stage that was reached. If the
    /// solution has not converged, the next call continues from its last equilibrium. The first load stage
    /// throws NumericalError if the structure can move without strain in spite of its supports. Throws
    /// Stopped.
    Solution advance(const StageTarget& target);

  private:
    class Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace fretwork::mechanics
