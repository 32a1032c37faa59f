// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/optimization/methods/detail/best_run.hpp>

#include <limits>
#include <utility>

namespace fretwork::optimization::detail {

BestRun::BestRun(const Evaluator& evaluator)
    : evaluator_(evaluator), best_value_(std::numeric_limits<double>::infinity()) {}

void BestRun::add(RunOutcome run) {
    const int dead = outcome_.dead_starts + (run.ending == Ending::Invalid ? 1 : 0);
    is_over_ = run.ending == Ending::BudgetSpent;
    // The value of a dead start is that of a point drawn at random, not the end of a descent.
    const bool is_better = run.ending != Ending::Invalid && evaluator_.best_value() < best_value_;
    const bool is_first = outcome_.ending == Ending::Invalid;
    if (run.ending != Ending::Invalid) best_value_ = evaluator_.best_value();
    if (is_over_ || is_better || is_first) outcome_ = std::move(run);
    outcome_.dead_starts = dead;
}

}  // namespace fretwork::optimization::detail
