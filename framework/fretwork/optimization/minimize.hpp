// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/optimization/optimizer_catalogue.hpp>

#include <string>
#include <vector>

namespace fretwork::optimization {

/// The outcome of a run.
struct OptimizationReport {
    std::string optimizer;              ///< name of the method
    Ending ending = Ending::Converged;  ///< how it ended
    Eigen::VectorXd point;              ///< the best point found; empty if the objective was never finite
    double value = 0.0;                 ///< the objective there
    Eigen::VectorXd final_point;        ///< the point at which the method itself ended
    long cost = 0;                      ///< in the problem's unit
    long evaluations = 0;               ///< number of evaluations of any kind
    long derivative_evaluations = 0;    ///< evaluations with derivatives
    int dead_starts = 0;                ///< starts that gave no descent; if all did, `ending` is Invalid
    long failures = 0;                  ///< evaluations whose objective was not finite
    long points_outside = 0;            ///< evaluations refused outside the bounds, a fault of the method
    std::vector<TracePoint> trace;      ///< the best objective over the cost
};

/// Minimize a problem by the method of this row. The same arguments give the same report, unless a budget in
/// seconds ends the run. Throws InputError if an option is invalid, or the problem does not offer the
/// evaluations that the method needs; base::Stopped if the budget's control asks to stop.
OptimizationReport minimize(const Problem& problem, const OptimizerRow& method,
                            const OptimizerOptions& options = {}, const Budget& budget = {});

/// Minimize a problem by a method that has no row in a catalogue.
OptimizationReport minimize(const Problem& problem, const Optimizer& optimizer, const Budget& budget = {});

}  // namespace fretwork::optimization
