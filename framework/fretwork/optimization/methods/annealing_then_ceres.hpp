// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/optimization/methods/multistart.hpp>
#include <fretwork/optimization/methods/simulated_annealing.hpp>

#include <memory>

namespace fretwork::optimization {

/// Options of annealing that is followed by a descent.
struct AnnealingThenCeresOptions {
    /// Options of the annealing; `starts` is the number of runs, each of one annealing and one descent.
    SimulatedAnnealingOptions annealing{};
    ContinuationOptions continuation{};  ///< options of the descent; `samples_per_start` is ignored
    /// Throws InputError if a value is invalid.
    void validate() const;
};

/// Simulated annealing until it is frozen or has made its largest number of moves, then a descent by Ceres
/// from the best point so far, as in make_ceres_multistart. A comparison with annealing alone, the paper's
/// method, shows the gain from the descent. Throws InputError if an option is invalid.
std::unique_ptr<Optimizer> make_annealing_then_ceres(const AnnealingThenCeresOptions& options);

}  // namespace fretwork::optimization
