// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/optimization/methods/multistart.hpp>
#include <fretwork/optimization/methods/simulated_annealing.hpp>

#include <memory>

namespace fretwork::optimization {

/// Options of annealing with a descent behind it.
struct AnnealingThenCeresOptions {
    /// Its `starts` is the number of runs; each run is one annealing followed by one descent.
    SimulatedAnnealingOptions annealing{};
    ContinuationOptions continuation{};  ///< of the descent
    /// Throws InputError if a value is invalid.
    void validate() const;
};

/// Simulated annealing until it is frozen, then a descent by Ceres from the best point so far, as in
/// make_ceres_multistart. The comparison with annealing alone, the paper's method, shows what a descent adds.
std::unique_ptr<Optimizer> make_annealing_then_ceres(const AnnealingThenCeresOptions& options);

}  // namespace fretwork::optimization
