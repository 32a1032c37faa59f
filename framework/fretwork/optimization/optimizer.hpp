// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/optimization/evaluator.hpp>

#include <cstdint>
#include <string_view>

namespace fretwork::optimization {

/// The kind of search that a method performs.
enum class OptimizerClass {
    Local,  ///< the method descends from each of `starts` points to a minimum nearby
    /// The method searches the whole box by a deterministic plan and ignores `starts` and the seed.
    Global,
    Random,  ///< the method draws points at random; most of these methods make `starts` runs
};
/// The word for a class in tables.
std::string_view optimizer_class_name(OptimizerClass kind);

/// The way in which a run ended.
enum class Ending {
    Converged,    ///< the method's own criterion was met
    BudgetSpent,  ///< an evaluation was refused because the rest of the budget did not cover it
    Stalled,      ///< the method's progress or iterations ended before its criterion was met
    /// No start gave a descent: the objective or its derivatives were not finite at the start, or the first
    /// step failed.
    Invalid,
    /// An outside program did not come to its end, and was stopped; see outside_command_row().
    Stopped,
};
/// The word for an ending in tables.
std::string_view ending_name(Ending ending);

/// The options that all methods understand.
struct OptimizerOptions {
    int starts = 4;  ///< number of descents, or of repetitions of a method without descents; 1 to 100,000
    std::uint64_t seed = 1;  ///< seed of all random choices
    /// Throws InputError if a value is invalid.
    void validate() const;
};

/// The outcome of a run: why and where the method ended. The final point need not be the best point. Reason
/// and point belong to the start in which the budget was spent or, if no start spent it, to the start that
/// found the best value.
struct RunOutcome {
    Ending ending = Ending::Converged;  ///< the reason why the method ended
    Eigen::VectorXd final_point;        ///< the point at which the method ended; empty: not known
    /// Number of starts that gave no descent: the objective was not finite, or the method gave up after the
    /// first evaluation. Only ceres-residuals, its variants and methods of NLopt with starts count them.
    int dead_starts = 0;
};

/// A minimization method. A method evaluates the problem only through the evaluator, and ends once the budget
/// does not cover an evaluation.
class Optimizer {
  public:
    virtual ~Optimizer() = default;
    /// Minimize the evaluator's problem. The evaluator keeps the best point and the budget. Throws
    /// base::Stopped if the budget's control asks to stop. Errors of the problem pass through, and so do
    /// errors of an outside program (see outside_command_row()).
    virtual RunOutcome run(Evaluator& evaluator) const = 0;
};

}  // namespace fretwork::optimization
