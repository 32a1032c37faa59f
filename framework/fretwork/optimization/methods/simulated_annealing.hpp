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

/// The variables in which annealing moves, as shares of the range between their bounds.
enum class AnnealingVariables {
    Problem,     ///< the problem's variables
    Quantities,  ///< the quantities whose logarithms are the problem's variables; see Problem::is_logarithm
};

/// Options of simulated annealing. The defaults are the defaults of ensmallen 2's SA with its exponential
/// schedule [Curtin2021].
struct SimulatedAnnealingOptions {
    OptimizerOptions common{};         ///< seed, and the number `starts` of runs, one after the other
    long largest_moves = 1'000'000;    ///< largest number of moves of one run after the initial moves
    double initial_temperature = 1e4;  ///< initial temperature T, in units of the objective
    long initial_moves = 1000;         ///< number of moves at the initial temperature
    /// Relative decrease of T: after each later move, T becomes (1 - cooling) T.
    double cooling = 1e-3;
    /// Number of sweeps, with one move of each variable, between two adaptations of the moves' scales.
    int sweeps_per_adaptation = 100;
    /// In a frozen run, each move changes the objective by less than this number. 0: no run freezes.
    double tolerance = 1e-5;
    /// A run ends, frozen, after this number of adaptations with all moves within the tolerance.
    int frozen_adaptations = 3;
    /// Initial scale of the Laplace distributed moves, as a share of the box.
    double initial_move = 0.3;
    double largest_move = 20.0;                         ///< largest scale of the moves, as a share of the box
    double gain = 0.3;                                  ///< rate of adaptation of the scales
    AnnealingBounds bounds = AnnealingBounds::Reflect;  ///< the treatment of moves beyond a bound
    AnnealingVariables variables = AnnealingVariables::Problem;  ///< the variables in which annealing moves
    /// Throws InputError if a value is invalid.
    void validate() const;
};

/// The paper's annealing, as published in ensmallen: a move changes one variable, and each variable's scale
/// is adapted towards an acceptance of 0.44 [LamDelosme1988]. ensmallen leaves some choices open. The
/// treatment of bounds and the choice of variables are options. Two choices are fixed: variables are shares
/// of the box, and starts are low-discrepancy points. The final point of the method is the last accepted
/// point; the report also has the best point. Throws InputError if an option is invalid.
std::unique_ptr<Optimizer> make_simulated_annealing(const SimulatedAnnealingOptions& options);

}  // namespace fretwork::optimization
