// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/optimization/detail/pagmo_optimizer.hpp>
#include <fretwork/optimization/differential_evolution.hpp>

#include <algorithm>
#include <pagmo/algorithms/de.hpp>

namespace fretwork::optimization {
namespace {

detail::Evolution evolution(const PagmoOptions& options, const detail::EvolutionTask& task) {
    constexpr double kWeight = 0.8;
    constexpr double kCrossover = 0.9;
    constexpr unsigned kRandOneExp = 2;
    return {
        pagmo::algorithm(pagmo::de(static_cast<unsigned>(options.largest_generations), kWeight, kCrossover,
                                   kRandOneExp, options.tolerance, options.tolerance, task.seed)),
        std::max<std::size_t>(10 * static_cast<std::size_t>(task.dimension), 5)};
}

}  // namespace

std::unique_ptr<Optimizer> make_differential_evolution(const PagmoOptions& options) {
    return detail::make_pagmo_runs(evolution, options);
}

}  // namespace fretwork::optimization
