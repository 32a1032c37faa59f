// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/optimization/methods/detail/starts.hpp>
#include <fretwork/optimization/sampling.hpp>

#include <algorithm>
#include <limits>
#include <utility>

namespace fretwork::optimization::detail {
namespace {

using ValuedPoint = std::pair<double, Eigen::VectorXd>;

std::vector<ValuedPoint> evaluate_samples(Evaluator& evaluator, const LowDiscrepancySequence& sequence,
                                          long samples) {
    std::vector<ValuedPoint> result;
    for (long i = 0; i < samples; ++i) {
        Eigen::VectorXd point = evaluator.bounds().at_shares(sequence.point(i));
        const auto value = evaluator.value(point);
        if (!value) break;
        result.emplace_back(*value, std::move(point));
    }
    return result;
}

}  // namespace

std::vector<Eigen::VectorXd> choose_starts(Evaluator& evaluator, const OptimizerOptions& options,
                                           long samples) {
    const LowDiscrepancySequence sequence(evaluator.bounds().dimension(), options.seed);
    std::vector<Eigen::VectorXd> starts;
    if (samples <= options.starts) {
        for (int i = 0; i < options.starts; ++i) {
            starts.push_back(evaluator.bounds().at_shares(sequence.point(i)));
        }
        return starts;
    }
    auto valued = evaluate_samples(evaluator, sequence, samples);
    std::ranges::stable_sort(valued, {}, &ValuedPoint::first);
    for (auto& [value, point] : valued) {
        if (std::ssize(starts) == options.starts) break;
        starts.push_back(std::move(point));
    }
    return starts;
}

BestRun::BestRun(const Evaluator& evaluator)
    : evaluator_(evaluator), best_value_(std::numeric_limits<double>::infinity()) {}

void BestRun::add(RunOutcome run) {
    const int dead = outcome_.dead_starts + (run.ending == Ending::Invalid ? 1 : 0);
    is_over_ = run.ending == Ending::BudgetSpent;
    // The value of a dead start belongs to its starting point, not to the end of a descent.
    const bool is_better = run.ending != Ending::Invalid && evaluator_.best_value() < best_value_;
    const bool is_first = outcome_.ending == Ending::Invalid;
    if (run.ending != Ending::Invalid) best_value_ = evaluator_.best_value();
    if (is_over_ || is_better || is_first) outcome_ = std::move(run);
    outcome_.dead_starts = dead;
}

}  // namespace fretwork::optimization::detail
