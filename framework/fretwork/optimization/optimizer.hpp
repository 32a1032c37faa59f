// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/optimization/evaluator.hpp>

#include <cstdint>
#include <string_view>

namespace fretwork::optimization {

/// The claim of a method.
enum class OptimizerClass {
    Local,   ///< descends from each of `starts` points to a minimum near it
    Global,  ///< searches the whole box by a deterministic plan: neither `starts` nor the seed matters
    Random,  ///< draws at random, `starts` times over
};
std::string_view optimizer_class_name(OptimizerClass kind);

/// How a run ended.
enum class Ending {
    Converged,    ///< by the method's own criterion
    BudgetSpent,  ///< an evaluation was refused because the budget does not pay for it
    Stalled,      ///< the method found no way on before its criterion was met
    Invalid,      ///< no descent: the objective was finite nowhere, or each start died where it began
};
std::string_view ending_name(Ending ending);

/// The options that all methods understand.
struct OptimizerOptions {
    int starts = 4;  ///< descents, or repetitions of a method that has none; 1 to 100,000
    std::uint64_t seed = 1;
    /// Throws InputError if a value is invalid.
    void validate() const;
};

/// How a method left: why, and where it stood, which need not be the best point that it saw. With several
/// starts both are of the start that found the best value, unless the budget was spent.
struct RunOutcome {
    Ending ending = Ending::Converged;
    Eigen::VectorXd final_point;
    int dead_starts = 0;  ///< starts that gave no descent: not finite, or given up at their first evaluation
};

/// A minimization method. It evaluates through the evaluator only, and stops once an evaluation is refused.
class Optimizer {
  public:
    virtual ~Optimizer() = default;
    virtual RunOutcome run(Evaluator& evaluator) const = 0;
};

}  // namespace fretwork::optimization
