// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/optimization/methods/detail/starts.hpp>
#include <fretwork/optimization/sampling.hpp>

#include <algorithm>
#include <utility>

namespace fretwork::optimization::detail {
namespace {

using ValuedPoint = std::pair<double, Eigen::VectorXd>;

std::vector<ValuedPoint> evaluate_samples(Evaluator& evaluator, const LowDiscrepancySequence& sequence,
                                          int samples) {
    std::vector<ValuedPoint> result;
    for (int i = 0; i < samples; ++i) {
        Eigen::VectorXd point = evaluator.bounds().at_shares(sequence.point(i));
        const auto value = evaluator.value(point);
        if (!value) break;
        result.emplace_back(*value, std::move(point));
    }
    return result;
}

}  // namespace

std::vector<Eigen::VectorXd> choose_starts(Evaluator& evaluator, const OptimizerOptions& options,
                                           int samples) {
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

}  // namespace fretwork::optimization::detail
