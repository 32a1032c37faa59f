// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/paths/equilibrium.hpp>

#include <vector>

namespace fretwork::mechanics {

/// Options of tracing a path by arc length.
struct PathTracingOptions {
    double first_load_step = 0.05;     ///< share of the load in the first step; sets the arc length of the
                                       ///< first step
    double largest_load_factor = 1.0;  ///< the path ends beyond this absolute value of the load factor
    double largest_arc = 0.5;  ///< largest arc length of one step, in rad and element lengths (root of the
                               ///< sum of squares)
    int steps = 200;           ///< number of steps after which the path ends
    /// A step that fails is halved as long as it is longer than the first step over 2^largest_cut_back.
    int largest_cut_back = 10;
    /// Options of the equilibria; only relative_residual, threads and control are used.
    EquilibriumOptions equilibrium{};
    /// Throws InputError if a value is invalid.
    void validate() const;
};

/// Follow the equilibrium path from rest by its arc length, also through limit points, where the load turns
/// back. Returns one solution for each point; their load factors rise and fall. If the path could not be
/// followed to its end, the last solution has not converged and holds the last equilibrium. A path also ends
/// where the relative rotation of the ends of an element reaches pi, as in follow_load_path(). Throws as that
/// function.
std::vector<Solution> trace_path(const Assembly& assembly, const PathTracingOptions& options = {});

}  // namespace fretwork::mechanics
