// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/optimization/optimizer.hpp>

#include <vector>

namespace fretwork::optimization::detail {

/// The points of the low-discrepancy sequence from which descents begin: of `samples` points those
/// `options.starts` with the best values, best first; with no more samples than starts, the first points,
/// unevaluated. Empty if the budget does not pay for a single sample.
std::vector<Eigen::VectorXd> choose_starts(Evaluator& evaluator, const OptimizerOptions& options,
                                           int samples);

/// How the best of several runs ended, and how many starts died. The whole search is cut short by a spent
/// budget, and invalid if all of its starts died.
class BestRun {
  public:
    explicit BestRun(const Evaluator& evaluator);
    /// Call it after each run, before the next one evaluates anything.
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
