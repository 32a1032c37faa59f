// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/optimization/optimizer.hpp>

#include <memory>

namespace fretwork::optimization {

/// The parts that the methods of pagmo share. They have its default parameters [Biscani2020] unless stated
/// otherwise, and work in the unit box.
struct PagmoOptions {
    OptimizerOptions common{};
    /// A run ends once its population differs by less, in the objective and in the variables (shares of the
    /// box).
    double tolerance = 1e-8;
    int largest_generations = 100'000;  ///< of one run
    /// Throws InputError if a value is invalid.
    void validate() const;
};

/// CMA-ES with bounds [Hansen2006], initial step 0.3 of the box; every restart doubles the population, which
/// begins with 4 + 3 ln n rounded down [Auger2005].
std::unique_ptr<Optimizer> make_cma_es(const PagmoOptions& options);

/// Simulated annealing with adaptive neighbourhoods [Corana1987]: temperature 10 down to 0.1 in ten steps,
/// with ten adjustments of the ranges at each.
std::unique_ptr<Optimizer> make_corana_annealing(const PagmoOptions& options);

/// Differential evolution, variant rand/1/exp, with ten individuals a variable [Storn1997].
std::unique_ptr<Optimizer> make_differential_evolution(const PagmoOptions& options);

}  // namespace fretwork::optimization
