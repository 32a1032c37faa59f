// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/optimization/optimizer_catalogue.hpp>

#include <string>
#include <vector>

namespace fretwork::optimization {

/// The outcome of a run.
struct OptimizationReport {
    std::string optimizer;              ///< name of the method; empty if it has no row in a catalogue
    Ending ending = Ending::Converged;  ///< the way in which the run ended
    Eigen::VectorXd point;              ///< the best point found; empty if the objective was never finite
    double value = 0.0;                 ///< objective at the best point; infinite if there is none
    Eigen::VectorXd final_point;        ///< the point at which the method itself ended; empty: not known
    long cost = 0;                      ///< cost of the run, in the problem's unit
    long evaluations = 0;               ///< number of evaluations of any kind
    long derivative_evaluations = 0;    ///< number of evaluations with derivatives
    /// Number of starts without a descent; if no start had a descent, `ending` is Invalid.
    int dead_starts = 0;
    long failures = 0;  ///< number of evaluations whose objective was not finite
    /// Number of evaluations refused because the method asked for a point outside the bounds.
    long points_outside = 0;
    std::vector<TracePoint> trace;  ///< the best objective over the cost
};

/// Minimize a problem by the method of a row of a catalogue. The same arguments give the same report, unless
/// a budget in seconds ends the run. Throws InputError if an option, the budget or a bound is invalid, or if
/// the problem does not offer the evaluations that the method needs. Throws as Optimizer::run().
OptimizationReport minimize(const Problem& problem, const OptimizerRow& method,
                            const OptimizerOptions& options = {}, const Budget& budget = {});

/// Minimize a problem by a method that has no row in a catalogue. Throws InputError if the budget or a bound
/// is invalid. Throws as Optimizer::run().
OptimizationReport minimize(const Problem& problem, const Optimizer& optimizer, const Budget& budget = {});

}  // namespace fretwork::optimization
