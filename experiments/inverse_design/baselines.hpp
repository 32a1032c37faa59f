// SPDX-License-Identifier: GPL-3.0-or-later
// Other searches, on the same reduced model: their work is counted in the same nonlinear solutions.
#pragma once

#include <fretwork/design/search/trials.hpp>

#include <cstdint>
#include <vector>

namespace fretwork::experiments {

struct Baseline {
    design::detail::Point point;
    double objective = 0.0;
    long swaps = 0;  ///< that were scored by a table's answers
};

/// Random paintings.
Baseline random_paintings(design::detail::Trials& trials, int solutions, std::uint64_t seed);
/// From a painting: the one swap that the linearized surface says is best, a solution, and so on.
Baseline greedy_swaps(design::detail::Trials& trials, const design::detail::Point& start, int solutions);
/// From a painting: random swaps of one tile, each with its own solution, accepted by Metropolis' rule at a
/// falling temperature.
Baseline annealing(design::detail::Trials& trials, const design::detail::Point& start, int solutions,
                   std::uint64_t seed);

/// The work of a search.
struct Work {
    int solutions = 0;
    long swaps = 0;  ///< swaps scored by the table's answers
};
/// From a painting: random swaps of one tile, scored by the table's superposed answers and accepted by
/// Metropolis' rule at a falling temperature; so many of them, then a solution decides, and the next table is
/// that of its equilibrium. A trust region on the energy of the change is that of the design.
Baseline table_annealing(design::detail::Trials& trials, const design::detail::Point& start, const Work& work,
                         std::uint64_t seed);

/// CMA-ES of pagmo on a number for each tile: its pattern's place between the softest and the stiffest,
/// rounded where it is solved.
/// @param order  candidates from soft to stiff
Baseline cma_es(design::detail::Trials& trials, const std::vector<std::size_t>& order, int solutions,
                std::uint64_t seed);

}  // namespace fretwork::experiments
