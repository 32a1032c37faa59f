// SPDX-License-Identifier: GPL-3.0-or-later
// The uniform paintings with which a search begins.
#include <fretwork/design/search/search.hpp>
#include <fretwork/design/search/uniform_guess.hpp>

#include <algorithm>
#include <functional>
#include <limits>

namespace fretwork::design::detail {
namespace {

/// For the first painting: the number of uniform paintings before it, the largest number of steps from the
/// best of these, and the radius of the first step. The steps end at kEarlyShare times the objective of this
/// best one, or if a step is predicted to gain less than kEarlyGain times the present objective.
constexpr std::size_t kEarlyUniform = 3;
constexpr int kEarlySteps = 5;
constexpr double kEarlyRadius = 0.5;
constexpr double kEarlyShare = 0.01;
constexpr double kEarlyGain = 0.25;

/// The weighted sum of the displacements of solutions.
std::vector<mechanics::NodeValues> superposed(const std::vector<Solved>& solved,
                                              const Eigen::VectorXd& weights) {
    std::vector<mechanics::NodeValues> sum = solved.front().trial.displacements;
    for (std::size_t c = 0; c < sum.size(); ++c) {
        sum[c] *= weights[0];
        for (std::size_t i = 1; i < solved.size(); ++i)
            sum[c] += weights[static_cast<Eigen::Index>(i)] * solved[i].trial.displacements[c];
    }
    return sum;
}

}  // namespace

void Search::try_one_uniform(std::size_t pattern, std::vector<Solved>& found) {
    const Point point = trials_.uniform(pattern);
    Trial trial = solve(point);
    ++report_.uniform_tried;
    if (!trial.is_found) return;
    found.push_back({point, std::move(trial)});
    note(found.back());
}

Search::Beginning Search::begin(const std::vector<std::size_t>& palette) {
    Beginning beginning;
    for (std::size_t p = 0; p < std::min(palette.size(), kEarlyUniform) && may_solve(); ++p)
        try_one_uniform(palette[p], beginning.uniform);
    if (beginning.uniform.empty()) return beginning;
    const Solved& best = *std::ranges::min_element(
        beginning.uniform, {}, [](const Solved& solved) { return solved.trial.objective; });
    set_columns(palette, palette);
    Solved current = best;
    if (!trials_.is_at(current.point)) current.trial = solve(current.point);
    double radius = kEarlyRadius;
    for (int round = 0; round < kEarlySteps && may_go_on(0.0) && current.trial.is_found; ++round) {
        if (current.trial.objective <= kEarlyShare * best.trial.objective) break;
        if (step(current, radius, round, {kEarlyGain, 0.0}) != Step::Better) break;
    }
    if (current.trial.is_found && current.trial.objective < best.trial.objective)
        beginning.painted = std::move(current);
    return beginning;
}

std::vector<Solved> Search::try_uniform(const std::vector<std::size_t>& palette,
                                        const Eigen::MatrixXd& coordinates, std::vector<Solved> found) {
    const auto may_try = [&] {
        return may_solve() && (found.empty() || time_.has_left(0.7 * options_.seconds));
    };
    const std::size_t most = std::min(palette.size(), options_.uniform_paintings);
    const std::size_t spread = std::min(most, std::max<std::size_t>(2, (2 * most) / 3));
    std::vector<bool> is_tried(palette.size(), false);
    for (std::size_t p = 0; p < palette.size(); ++p) is_tried[p] = is_seen(trials_.uniform(palette[p]));
    for (std::size_t p = 0; p < palette.size() && report_.uniform_tried < most && may_try(); ++p) {
        if (report_.uniform_tried >= spread && found.size() >= 2) break;
        if (is_tried[p]) continue;
        try_one_uniform(palette[p], found);
        is_tried[p] = true;
    }
    while (report_.uniform_tried < most && may_try()) {
        const std::size_t next = predicted_best(found, palette, coordinates, is_tried);
        if (next == palette.size()) break;
        try_one_uniform(palette[next], found);
        is_tried[next] = true;
    }
    std::ranges::stable_sort(found, std::bind_front(&Search::is_better, this));
    return found;
}

/// The index of the palette's pattern whose uniform painting is predicted to be the best of those that are
/// not tried; the palette's size if there is none.
std::size_t Search::predicted_best(const std::vector<Solved>& found, const std::vector<std::size_t>& palette,
                                   const Eigen::MatrixXd& coordinates,
                                   const std::vector<bool>& is_tried) const {
    std::vector<Eigen::Index> places;
    for (const Solved& solved : found)
        places.push_back(std::ranges::find(palette, solved.point.patterns.front()) - palette.begin());
    const Eigen::MatrixXd known = coordinates(Eigen::all, places);
    std::size_t best = palette.size();
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t p = 0; p < static_cast<std::size_t>(coordinates.cols()) && p < palette.size(); ++p) {
        if (is_tried[p]) continue;
        const Eigen::VectorXd weights =
            prediction_weights(known, coordinates.col(static_cast<Eigen::Index>(p)));
        const double objective = trials_.objective_of(superposed(found, weights));
        if (objective < least) {
            least = objective;
            best = p;
        }
    }
    return best;
}

}  // namespace fretwork::design::detail
