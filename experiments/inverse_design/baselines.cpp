// SPDX-License-Identifier: GPL-3.0-or-later
#include "baselines.hpp"

#include <fretwork/base/random.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace fretwork::experiments {

using design::detail::Point;
using design::detail::SwapTable;
using design::detail::Trial;
using design::detail::Trials;

Baseline random_paintings(Trials& trials, int solutions, std::uint64_t seed) {
    base::SplitMix64 random(seed);
    Baseline best{{}, std::numeric_limits<double>::infinity()};
    const std::size_t patterns = trials.parts().candidates.patterns().size();
    for (const int end = trials.solutions() + solutions; trials.solutions() < end;) {
        Point point = trials.uniform(0);
        for (std::size_t& pattern : point.patterns) pattern = random.below(patterns);
        const Trial trial = trials.solve(point, {});
        if (trial.is_found && trial.objective < best.objective) best = {point, trial.objective};
    }
    return best;
}

Baseline greedy_swaps(Trials& trials, const Point& start, int solutions) {
    std::vector<std::size_t> columns(trials.parts().candidates.patterns().size());
    std::iota(columns.begin(), columns.end(), std::size_t{0});
    Point point = start;
    const int end = trials.solutions() + solutions;
    Trial trial = trials.solve(point, {});
    while (trials.solutions() < end) {
        const SwapTable table = trials.table(point, trial, columns, 1, {});
        double best = table.residual.squaredNorm();
        Point next = point;
        for (std::size_t g = 0; g < table.groups(); ++g) {
            for (std::size_t c = 0; c < columns.size(); ++c) {
                const double found =
                    (table.residual + table.responses[g].col(static_cast<Eigen::Index>(c))).squaredNorm();
                if (found >= best) continue;
                best = found;
                next = point;
                next.patterns[g] = columns[c];
            }
        }
        if (next == point) break;
        Trial swapped = trials.solve(next, {});
        if (!swapped.is_found || swapped.objective >= trial.objective) break;
        point = std::move(next);
        trial = std::move(swapped);
    }
    return {point, trial.objective};
}

Baseline annealing(Trials& trials, const Point& start, int solutions, std::uint64_t seed) {
    base::SplitMix64 random(seed);
    const std::size_t patterns = trials.parts().candidates.patterns().size();
    const int begin = trials.solutions();
    Point point = start;
    double objective = trials.solve(point, {}).objective;
    Baseline best{point, objective};
    const double first = 0.1 * objective;
    while (trials.solutions() < begin + solutions) {
        const double share = static_cast<double>(trials.solutions() - begin) / solutions;
        const double temperature = first * std::pow(1e-4, share);
        Point next = point;
        next.patterns[random.below(next.patterns.size())] = random.below(patterns);
        const Trial trial = trials.solve(next, {});
        if (!trial.is_found) continue;
        if (trial.objective > objective &&
            random.share() >= std::exp((objective - trial.objective) / temperature))
            continue;
        point = std::move(next);
        objective = trial.objective;
        if (objective < best.objective) best = {point, objective};
    }
    return best;
}

}  // namespace fretwork::experiments
