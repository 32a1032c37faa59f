// SPDX-License-Identifier: GPL-3.0-or-later
// Other searches, on the same reduced model: their work is counted in the same nonlinear solutions.
#pragma once

#include <fretwork/design/search/trials.hpp>

#include <cstdint>

namespace fretwork::experiments {

struct Baseline {
    design::detail::Point point;
    double objective = 0.0;
};

/// Random paintings.
Baseline random_paintings(design::detail::Trials& trials, int solutions, std::uint64_t seed);
/// From a painting: the one swap that the linearized surface says is best, a solution, and so on.
Baseline greedy_swaps(design::detail::Trials& trials, const design::detail::Point& start, int solutions);
/// From a painting: random swaps of one tile, each with its own solution, accepted by Metropolis' rule at a
/// falling temperature.
Baseline annealing(design::detail::Trials& trials, const design::detail::Point& start, int solutions,
                   std::uint64_t seed);

}  // namespace fretwork::experiments
