// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/optimization/corana_annealing.hpp>
#include <fretwork/optimization/detail/pagmo_optimizer.hpp>

#include <pagmo/algorithms/simulated_annealing.hpp>

namespace fretwork::optimization {
namespace {

detail::Evolution evolution(const PagmoOptions& /*options*/, const detail::EvolutionTask& task) {
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

}  // namespace

std::unique_ptr<Optimizer> make_corana_annealing(const PagmoOptions& options) {
    return detail::make_pagmo_runs(evolution, options);
}

}  // namespace fretwork::optimization
