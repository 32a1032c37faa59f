// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/optimization/methods/multistart.hpp>
#include <fretwork/optimization/methods/simulated_annealing.hpp>

#include <memory>

namespace fretwork::optimization {

struct AnnealingThenCeresOptions {
    SimulatedAnnealingOptions annealing{};  ///< its `starts`: so often both, one after the other
    ContinuationOptions continuation{};
    void validate() const;
};

/// Simulated annealing until it is frozen, then a descent by Ceres from the best point so far, as in
/// make_ceres_multistart: what the descent adds to the paper's choice.
std::unique_ptr<Optimizer> make_annealing_then_ceres(const AnnealingThenCeresOptions& options);

}  // namespace fretwork::optimization
