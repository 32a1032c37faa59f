// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/optimization/optimizer.hpp>

#include <memory>

namespace fretwork::optimization {

/// Options of the methods of pagmo. Parameters that are not stated here are pagmo's defaults [Biscani2020].
/// The methods search in the unit box.
struct PagmoOptions {
    OptimizerOptions common{};  ///< number of starts, and seed
    /// A run ends if the objectives of its population differ by less than this number. It also ends if the
    /// variables (as shares of the box) vary by less than this number.
    double tolerance = 1e-8;
    int largest_generations = 100'000;  ///< largest number of generations in one run
    /// Throws InputError if a value is invalid.
    void validate() const;
};

/// CMA-ES with bounds [Hansen2006] and an initial step of 0.3 of the box. For n variables, the first
/// population is 4 + 3 ln n, rounded down, but at least 5; each of the first 12 restarts doubles the
/// population [Auger2005]. Throws InputError if an option is invalid.
std::unique_ptr<Optimizer> make_cma_es(const PagmoOptions& options);

/// Simulated annealing with adaptive neighbourhoods [Corana1987]: the temperature falls from 10 to 0.1 in ten
/// steps, and the ranges of moves are adjusted ten times at each temperature. Only PagmoOptions::common is
/// used. Throws InputError if an option is invalid.
std::unique_ptr<Optimizer> make_corana_annealing(const PagmoOptions& options);

/// Differential evolution, variant rand/1/exp, with ten individuals for each variable [Storn1997]. Throws
/// InputError if an option is invalid.
std::unique_ptr<Optimizer> make_differential_evolution(const PagmoOptions& options);

}  // namespace fretwork::optimization
