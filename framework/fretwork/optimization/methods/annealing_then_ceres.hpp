// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/optimization/methods/multistart.hpp>
#include <fretwork/optimization/methods/simulated_annealing.hpp>

#include <memory>

namespace fretwork::optimization {

struct AnnealingThenCeresOptions {
    /// Its `starts` is how many times the pair, an annealing and a descent, is run.
    SimulatedAnnealingOptions annealing{};
    ContinuationOptions continuation{};
    void validate() const;
};

/// Simulated annealing until it is frozen, then a descent by Ceres from the best point so far, as in
/// make_ceres_multistart. Shows what a descent adds to annealing alone, the paper's choice.
std::unique_ptr<Optimizer> make_annealing_then_ceres(const AnnealingThenCeresOptions& options);

}  // namespace fretwork::optimization
