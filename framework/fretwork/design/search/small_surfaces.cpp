// SPDX-License-Identifier: GPL-3.0-or-later
// Surfaces with so few tiles and patterns that many paintings around the best one can be solved.
#include <fretwork/design/search/search.hpp>

#include <algorithm>
#include <utility>

namespace fretwork::design::detail {
namespace {

/// A surface is small if it has at most this number of groups x patterns, and max_patterns is 0.
constexpr std::size_t kSmallTable = 300;
/// The largest number of changes of one group, and of two groups, that are solved around one painting.
constexpr std::size_t kMostNeighbours = 60;
/// All paintings are ranked if there are at most kMostPaintings. The best kMostRanked of them are then solved
/// around one painting.
constexpr std::size_t kMostPaintings = 1'000'000;
constexpr std::size_t kMostRanked = 60;

}  // namespace

bool Search::is_small() const {
    return trials_.parts().groups.size() * all_.size() <= kSmallTable && options_.max_patterns == 0;
}

bool Search::can_rank_all() const {
    return is_small() &&
           choice_count(trials_.parts().groups.size(), all_.size(), kMostPaintings) <= kMostPaintings &&
           trials_.has_few_pairs(all_.size());
}

std::vector<Point> Search::promising(Solved& best) {
    if (!return_to(best)) return {};
    std::vector<std::size_t> columns = all_;
    std::ranges::sort(columns);
    const base::Control silent = options_.control.silent();
    std::vector<Choice> choices;
    if (can_rank_all()) {
        // Solved paintings are ranked, too, and dropped below.
        choices = best_of_all(trials_.pair_table(best.point, best.trial, columns, options_.seed, silent),
                              kMostRanked + seen_.size(), silent);
    } else {
        choices = neighbours(trials_.table(best.point, best.trial, columns, options_.seed, silent),
                             places_of(best.point.patterns, columns), std::vector<bool>(all_.size(), true),
                             kMostNeighbours, silent);
    }
    std::vector<Point> points;
    for (const Choice& choice : choices) {
        Point next = painted(best.point, choice, columns);
        next.unknowns = trials_.bounded(next.unknowns + choice.steps);
        if (is_seen(next) || next == best.point) continue;
        if (!keeps_mass(next)) continue;
        points.push_back(std::move(next));
    }
    if (can_rank_all() && points.size() > kMostRanked) points.resize(kMostRanked);
    return points;
}

Solved Search::search_nearby(Solved best, double reserve, int last_solution) {
    const auto has_budget = [&] { return may_go_on(reserve) && trials_.solutions() < last_solution; };
    for (bool is_better = true; is_better && has_budget() && best.trial.objective > kReachedObjective;) {
        is_better = false;
        for (const Point& next : promising(best)) {
            if (!has_budget()) break;
            Trial trial = solve(next);
            if (!trial.is_found || trial.objective >= best.trial.objective) continue;
            best = {next, std::move(trial)};
            note(best);
            is_better = true;
            break;
        }
    }
    return best;
}

}  // namespace fretwork::design::detail
