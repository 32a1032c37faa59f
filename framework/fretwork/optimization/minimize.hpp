// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/optimization/optimizer_catalogue.hpp>

#include <string>
#include <vector>

namespace fretwork::optimization {

/// The outcome of a run.
struct OptimizationReport {
    std::string optimizer;
    Ending ending = Ending::Converged;
    Eigen::VectorXd point;        ///< the best that was seen; empty if the objective was finite nowhere
    double value = 0.0;           ///< the objective there
    Eigen::VectorXd final_point;  ///< where the method itself stood in the end
    long cost = 0;                ///< in the problem's unit
    long evaluations = 0;         ///< of any kind
    long derivative_evaluations = 0;
    int dead_starts = 0;      ///< starts that gave no descent; all of them: the ending is Invalid
    long failures = 0;        ///< evaluations whose objective was not finite
    long points_outside = 0;  ///< refused: a method that asks for them is at fault
    std::vector<TracePoint> trace;
};

/// Minimize a problem by the method of this row. The same arguments give the same report, except where a
/// budget in seconds cuts in. Throws InputError if an option is invalid, or the problem does not offer what
/// the method needs; base::Stopped once the budget's control asks to stop.
OptimizationReport minimize(const Problem& problem, const OptimizerRow& method,
                            const OptimizerOptions& options = {}, const Budget& budget = {});

/// The same by a method that is in no catalogue.
OptimizationReport minimize(const Problem& problem, const Optimizer& optimizer, const Budget& budget = {});

}  // namespace fretwork::optimization
