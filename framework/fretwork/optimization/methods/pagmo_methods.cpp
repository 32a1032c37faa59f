// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/optimization/methods/detail/option_checks.hpp>
#include <fretwork/optimization/methods/detail/pagmo_optimizer.hpp>
#include <fretwork/optimization/methods/pagmo_methods.hpp>

#include <algorithm>
#include <cmath>
#include <pagmo/algorithms/cmaes.hpp>
#include <pagmo/algorithms/de.hpp>
#include <pagmo/algorithms/simulated_annealing.hpp>

namespace fretwork::optimization {
namespace {

using detail::Evolution;
using detail::EvolutionTask;

/// The smallest population that pagmo accepts.
constexpr std::size_t kSmallestPopulation = 5;

/// The evaluations of a first population and of all generations after it.
long evaluations_of(std::size_t population, const PagmoOptions& options) {
    return static_cast<long>(population) * (1L + options.largest_generations);
}

Evolution cma_es(const PagmoOptions& options, const EvolutionTask& task) {
    constexpr double kAutomatic = -1.0;
    constexpr double kInitialStep = 0.3;
    constexpr int kLargestDoubling = 12;
    const auto smallest = static_cast<std::size_t>(4.0 + 3.0 * std::log(task.dimension));
    const std::size_t population = std::max(smallest, kSmallestPopulation)
                                   << std::min(task.run, kLargestDoubling);
    return {pagmo::algorithm(pagmo::cmaes(static_cast<unsigned>(options.largest_generations), kAutomatic,
                                          kAutomatic, kAutomatic, kAutomatic, kInitialStep, options.tolerance,
                                          options.tolerance, false, true, task.seed)),
            population, evaluations_of(population, options)};
}

Evolution corana_annealing(const PagmoOptions& /*options*/, const EvolutionTask& task) {
    constexpr double kFirstTemperature = 10.0;
    constexpr double kLastTemperature = 0.1;
    constexpr unsigned kTemperatures = 10;
    constexpr unsigned kRangeAdjustments = 10;
    constexpr unsigned kMovesForAdjustment = 20;
    constexpr double kFirstRange = 1.0;
    return {pagmo::algorithm(pagmo::simulated_annealing(kFirstTemperature, kLastTemperature, kTemperatures,
                                                        kRangeAdjustments, kMovesForAdjustment, kFirstRange,
                                                        task.seed)),
            1};
}

Evolution differential_evolution(const PagmoOptions& options, const EvolutionTask& task) {
    constexpr double kWeight = 0.8;
    constexpr double kCrossover = 0.9;
    constexpr unsigned kRandOneExp = 2;
    const std::size_t population =
        std::max(10 * static_cast<std::size_t>(task.dimension), kSmallestPopulation);
    return {
        pagmo::algorithm(pagmo::de(static_cast<unsigned>(options.largest_generations), kWeight, kCrossover,
                                   kRandOneExp, options.tolerance, options.tolerance, task.seed)),
        population, evaluations_of(population, options)};
}

}  // namespace

void PagmoOptions::validate() const {
    common.validate();
    detail::require_at_least(0.0, "tolerance", tolerance);
    detail::require_at_least(1.0, "largest_generations", static_cast<double>(largest_generations));
}

std::unique_ptr<Optimizer> make_cma_es(const PagmoOptions& options) {
    return detail::make_pagmo_runs(cma_es, options);
}

std::unique_ptr<Optimizer> make_corana_annealing(const PagmoOptions& options) {
    return detail::make_pagmo_runs(corana_annealing, options);
}

std::unique_ptr<Optimizer> make_differential_evolution(const PagmoOptions& options) {
    return detail::make_pagmo_runs(differential_evolution, options);
}

}  // namespace fretwork::optimization
