// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/optimization/methods/pagmo_methods.hpp>

#include <cstddef>
#include <memory>
#include <optional>
#include <pagmo/algorithm.hpp>

namespace fretwork::optimization::detail {

/// The input of a function that makes a method.
struct EvolutionTask {
    int dimension;  ///< number of variables
    int run;        ///< number of the run, from 0
    unsigned seed;  ///< seed of the run
};

/// One run of a method of pagmo: the method, and the size of its population.
struct Evolution {
    pagmo::algorithm algorithm;
    std::size_t population;
    /// Number of evaluations of a run that spends all its generations. None: the method has a schedule, and
    /// ends with it.
    std::optional<long> largest_evaluations{};
};
using MakeEvolution = Evolution (*)(const PagmoOptions& options, const EvolutionTask& task);

/// Runs of a method of pagmo, one after the other. Throws InputError if an option is invalid.
std::unique_ptr<Optimizer> make_pagmo_runs(MakeEvolution make, const PagmoOptions& options);

}  // namespace fretwork::optimization::detail
