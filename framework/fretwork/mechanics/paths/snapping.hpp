// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/solve.hpp>

#include <span>
#include <vector>

namespace fretwork::mechanics {

/// Follow the load path as follow_load_path does with Branch::Stable, and beyond limit loads: there, a
/// thousandth of the load farther, the structure goes downhill from its last equilibrium to a stable one, and
/// the path goes on from that. Each such place is one of Solution::stability_losses, at the limit load, with
/// the node and the component that move farthest, `pushed`. A motion with inertia may come to rest elsewhere
/// where there are several stable equilibria.
std::vector<Solution> follow_snapping_path(const Assembly& assembly, std::span<const double> load_factors,
                                           const EquilibriumOptions& options = {});

/// Solve a frame along such a path: as solve(), with Solver::Newton and without SolveOptions::branch.
Result solve_snapping(const LabelledFrame& frame, const SolveOptions& options = {});

}  // namespace fretwork::mechanics
