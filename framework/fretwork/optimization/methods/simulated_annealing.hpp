// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/optimization/optimizer.hpp>

#include <memory>

namespace fretwork::optimization {

/// The treatment of a move beyond a bound.
enum class AnnealingBounds {
    Reflect,  ///< the move is reflected at the bound
    Clamp,    ///< the move ends on the bound
    Reject,   ///< the move is rejected without an evaluation
};

/// The variables in which annealing moves, as shares of their box.
enum class AnnealingVariables {
    Problem,     ///< the problem's variables
    Quantities,  ///< the quantities whose logarithms are the problem's variables; see Problem::is_logarithm
};

/// Options of simulated annealing. The defaults are those of ensmallen 2's SA with its exponential schedule
/// [Curtin2021].
struct SimulatedAnnealingOptions {
    OptimizerOptions common{};         ///< `starts` runs, one after the other
    long largest_moves = 1'000'000;    ///< the most moves of one run after the initial ones
    double initial_temperature = 1e4;  ///< in units of the objective
    long initial_moves = 1000;         ///< at the initial temperature
    double cooling = 1e-3;             ///< T becomes (1 - cooling) T after each later move
    int sweeps_per_adaptation = 100;   ///< sweeps between changes of the moves
    double tolerance = 1e-5;           ///< a run is frozen after smaller changes ..
    int frozen_adaptations = 3;        ///< .. in this number of adaptations, one after the other
    double initial_move = 0.3;         ///< scale of the Laplace distributed move, as a share of the box
    double largest_move = 20.0;        ///< scale of a move at most
    double gain = 0.3;                 ///< how fast moves adapt
    AnnealingBounds bounds = AnnealingBounds::Reflect;           ///< what becomes of moves beyond a bound
    AnnealingVariables variables = AnnealingVariables::Problem;  ///< in which it moves
    /// Throws InputError if a value is invalid.
    void validate() const;
};

/// The annealing of the paper, as ensmallen publishes it: a move changes one variable, and each variable's
/// scale is adapted towards an acceptance of 0.44 [LamDelosme1988]. Choices that ensmallen leaves open are
/// options here (bounds, variables), or fixed as follows: variables are shares of the box, and starts are
/// low-discrepancy points. The method ends at the last accepted point; the report also has the best point.
std::unique_ptr<Optimizer> make_simulated_annealing(const SimulatedAnnealingOptions& options);

}  // namespace fretwork::optimization
