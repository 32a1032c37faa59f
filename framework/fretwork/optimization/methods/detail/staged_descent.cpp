// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/optimization/methods/detail/staged_descent.hpp>
#include <fretwork/optimization/methods/detail/starts.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace fretwork::optimization::detail {
namespace {

using Descents = std::vector<std::unique_ptr<StagedDescent>>;

double share_distance(const StagedDescent& one, const StagedDescent& other, const Bounds& bounds) {
    return ((one.point() - other.point()).array() / (bounds.upper - bounds.lower).array()).abs().maxCoeff();
}

/// The descents to continue. Of descents that have met, only the lowest is kept. A descent far above the
/// lowest of all is not kept. The lowest comes last.
Descents promising(Descents descents, const MultistartOptions& options, const Bounds& bounds) {
    std::ranges::stable_sort(descents, {}, [](const auto& descent) { return descent->value(); });
    const double lowest = descents.front()->value();
    const double highest = lowest + (options.pruning_ratio - 1.0) * std::abs(lowest);
    Descents kept;
    for (auto& descent : descents) {
        const bool is_met = std::ranges::any_of(kept, [&](const auto& other) {
            return share_distance(*descent, *other, bounds) < options.merging_distance;
        });
        const bool is_far = descent->value() > highest;  // false if `highest` is NaN: infinity times 0
        if (!is_met && !is_far) kept.push_back(std::move(descent));
    }
    std::ranges::reverse(kept);
    return kept;
}

}  // namespace

RunOutcome run_multistart(Evaluator& evaluator, const MultistartOptions& options,
                          const MakeDescent& make_descent) {
    const long samples = static_cast<long>(options.common.starts) * options.continuation.samples_per_start;
    Descents descents;
    for (Eigen::VectorXd& start : choose_starts(evaluator, options.common, samples)) {
        descents.push_back(make_descent(std::move(start)));
    }
    RunOutcome outcome{Ending::BudgetSpent, {}};
    if (descents.empty()) return outcome;
    for (const double smoothing : options.continuation.smoothing) {
        std::optional<double> lowest;
        for (const auto& descent : descents) {
            const Ending ending = descent->run_stage(smoothing);
            if (ending == Ending::BudgetSpent) return {ending, descent->point()};
            if (lowest && !(descent->value() < *lowest)) continue;
            lowest = descent->value();
            outcome = {ending, descent->point()};
        }
        descents = promising(std::move(descents), options, evaluator.bounds());
    }
    return outcome;
}

}  // namespace fretwork::optimization::detail
