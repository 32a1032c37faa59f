// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/optimization/cma_es.hpp>
#include <fretwork/optimization/detail/pagmo_optimizer.hpp>

#include <algorithm>
#include <cmath>
#include <pagmo/algorithms/cmaes.hpp>

namespace fretwork::optimization {
namespace {

detail::Evolution evolution(const PagmoOptions& options, const detail::EvolutionTask& task) {
    constexpr double kAutomatic = -1.0;
    constexpr double kInitialStep = 0.3;
    constexpr int kLargestDoubling = 12;
    const auto smallest = static_cast<std::size_t>(4.0 + 3.0 * std::log(task.dimension));
    return {pagmo::algorithm(pagmo::cmaes(static_cast<unsigned>(options.largest_generations), kAutomatic,
                                          kAutomatic, kAutomatic, kAutomatic, kInitialStep, options.tolerance,
                                          options.tolerance, false, true, task.seed)),
            std::max<std::size_t>(smallest, 5) << std::min(task.run, kLargestDoubling)};
}

}  // namespace

std::unique_ptr<Optimizer> make_cma_es(const PagmoOptions& options) {
    return detail::make_pagmo_runs(evolution, options);
}

}  // namespace fretwork::optimization
