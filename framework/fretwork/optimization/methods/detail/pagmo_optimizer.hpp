// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/optimization/methods/pagmo_methods.hpp>

#include <cstddef>
#include <memory>
#include <pagmo/algorithm.hpp>

namespace fretwork::optimization::detail {

/// The input of a factory of methods.
struct EvolutionTask {
    int dimension;  ///< of the problem
    int run;        ///< from 0
    unsigned seed;  ///< of this run
};

/// One run of a method of pagmo: what evolves, and how many individuals.
struct Evolution {
    pagmo::algorithm algorithm;
    std::size_t population;
};
using MakeEvolution = Evolution (*)(const PagmoOptions& options, const EvolutionTask& task);

/// Runs one after the other. Throws InputError if an option is invalid.
std::unique_ptr<Optimizer> make_pagmo_runs(MakeEvolution make, const PagmoOptions& options);

}  // namespace fretwork::optimization::detail
