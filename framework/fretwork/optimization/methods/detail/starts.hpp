// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/optimization/optimizer.hpp>

#include <vector>

namespace fretwork::optimization::detail {

/// The points of the low-discrepancy sequence from which descents begin: of `samples` points, the
/// `options.starts` points with the best values, best first. If `samples` is at most `options.starts`, the
/// first `options.starts` points, not evaluated. Empty if the budget does not cover a single sample.
std::vector<Eigen::VectorXd> choose_starts(Evaluator& evaluator, const OptimizerOptions& options,
                                           long samples);

/// The outcome of the best of several runs, and the number of dead starts. The search ends as BudgetSpent if
/// the budget was spent, and as Invalid if all of its starts were dead.
class BestRun {
  public:
    explicit BestRun(const Evaluator& evaluator);
    /// Add a run. Call this function after each run, before the next run evaluates a point.
    void add(RunOutcome run);
    /// True once the budget is spent.
    [[nodiscard]] bool is_over() const { return is_over_; }
    [[nodiscard]] RunOutcome outcome() const { return outcome_; }

  private:
    const Evaluator& evaluator_;
    double best_value_;
    bool is_over_ = false;
    RunOutcome outcome_{Ending::Invalid, {}};
};

}  // namespace fretwork::optimization::detail
