// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/random.hpp>
#include <fretwork/design/search/search.hpp>

#include <algorithm>
#include <cmath>
#include <set>

namespace fretwork::design::detail {
namespace {

constexpr double kFirstRadius = 0.5;
constexpr double kLeastRadius = 1e-5;
constexpr double kLargestRadius = 4.0;
/// Proposals of one table, each with a smaller radius.
constexpr int kMostProposals = 4;
/// Steps that gain less than this share of the objective are no gain.
constexpr double kLeastGain = 1e-4;
/// Objectives (squares of shares) below this are the reduced model's rounding.
constexpr double kReached = 1e-14;
/// Uniform paintings from which the search begins, as long as there are solutions left; then the best
/// painting is kicked: so much of it is painted at random.
constexpr std::size_t kOtherStarts = 3;
constexpr std::uint64_t kMostKicks = 100;
constexpr double kKickedShare = 0.2;
/// Solutions that are left for the defect correction.
constexpr int kLeftForDefect = 10;

}  // namespace

void Search::set_columns(std::vector<std::size_t> shortlist, std::vector<std::size_t> all) {
    shortlist_ = std::move(shortlist);
    all_ = std::move(all);
}

bool Search::may_go_on(double reserve) const {
    return trials_.solutions() < options_.most_solutions && watch_.has_left(reserve + step_seconds_);
}

void Search::tell(const Solved& solved) {
    if (options_.max_mass > 0.0 && trials_.mass_of(solved.point) > options_.max_mass) return;
    if (best_ >= 0.0 && solved.trial.objective >= best_) return;
    best_ = solved.trial.objective;
    best_point_ = solved.point;
    const DesignProgress progress{trials_.solutions(), watch_.seconds(), std::sqrt(best_)};
    report_.history.push_back(progress);
    if (options_.on_better) options_.on_better(progress);
}

std::vector<Solved> Search::try_uniform(const std::vector<std::size_t>& patterns) {
    std::vector<Solved> found;
    for (const std::size_t pattern : patterns) {
        if (!found.empty() && !watch_.has_left(0.7 * options_.seconds)) break;
        const Point point = trials_.uniform(pattern);
        Trial trial = trials_.solve(point, options_.control);
        ++report_.uniform_tried;
        if (!trial.is_found) continue;
        found.push_back({point, std::move(trial)});
        tell(found.back());
    }
    std::ranges::stable_sort(found, {}, [](const Solved& solved) { return solved.trial.objective; });
    if (options_.max_mass > 0.0)
        std::ranges::stable_partition(found, [this](const Solved& solved) {
            return trials_.mass_of(solved.point) <= options_.max_mass;
        });
    return found;
}

/// The first round takes the shortlist; later ones take others at random, beside those that are used.
std::vector<std::size_t> Search::columns_for(const Point& point, int round) const {
    std::set<std::size_t> chosen(point.patterns.begin(), point.patterns.end());
    if (!limited_.empty()) {
        chosen.insert(limited_.begin(), limited_.end());
        return {chosen.begin(), chosen.end()};
    }
    if (round % 2 == 0 || all_.size() <= shortlist_.size()) {
        chosen.insert(shortlist_.begin(), shortlist_.end());
    } else {
        base::SplitMix64 random(base::SplitMix64::mix(options_.seed) + static_cast<std::uint64_t>(round));
        const std::size_t wanted = std::min(all_.size(), chosen.size() + shortlist_.size());
        while (chosen.size() < wanted) chosen.insert(all_[random.below(all_.size())]);
    }
    return {chosen.begin(), chosen.end()};
}

/// What is left for the groups of the most mass; zero: any.
double Search::mass_for_groups(const Point& point, const SwapTable& table,
                               const std::vector<std::size_t>& start) const {
    if (options_.max_mass <= 0.0) return 0.0;
    double left = options_.max_mass - trials_.mass_of(point);
    for (std::size_t g = 0; g < start.size(); ++g)
        left += table.masses(static_cast<Eigen::Index>(start[g]), static_cast<Eigen::Index>(g));
    return std::max(left, 1e-300);
}

void Search::limit_patterns(const Point& point, const SwapTable& table, const std::vector<std::size_t>& start,
                            const std::vector<std::size_t>& columns) {
    std::set<std::size_t> kept;
    for (const tiling::TileIndex tile : options_.keep) {
        const auto* own = tiling::pattern_of(trials_.parts().surface.tessellation, tile);
        const auto& all = trials_.parts().candidates.patterns();
        kept.insert(static_cast<std::size_t>(std::ranges::find(all, own->id, &pattern::NamedPattern::id) -
                                             all.begin()));
    }
    const std::size_t most = options_.max_patterns - kept.size();
    const SweepOptions sweeps{.allowed = std::vector<bool>(columns.size(), true),
                              .radius = kLargestRadius,
                              .most_mass = mass_for_groups(point, table, start),
                              .seed = options_.seed,
                              .control = options_.control.silent()};
    // The patterns at the start stay, so that it is a painting that may be.
    std::set<std::size_t> chosen(point.patterns.begin(), point.patterns.end());
    if (most > chosen.size()) {
        const auto allowed = fewer_columns(table, start, sweeps, most - chosen.size());
        for (std::size_t c = 0; c < columns.size(); ++c) {
            if (allowed[c]) chosen.insert(columns[c]);
        }
    }
    limited_.assign(chosen.begin(), chosen.end());
}

bool Search::step(Solved& current, double& radius, int round) {
    const std::vector<std::size_t> columns = columns_for(current.point, round);
    const auto column_of = [&columns](std::size_t pattern) {
        return static_cast<std::size_t>(std::ranges::lower_bound(columns, pattern) - columns.begin());
    };
    std::vector<std::size_t> start;
    for (const std::size_t pattern : current.point.patterns) start.push_back(column_of(pattern));
    const SwapTable table =
        trials_.table(current.point, current.trial, columns,
                      options_.seed + static_cast<std::uint64_t>(round), options_.control);
    SweepOptions sweeps{.allowed = std::vector<bool>(columns.size(), true),
                        .most_mass = mass_for_groups(current.point, table, start),
                        .control = options_.control.silent()};
    if (options_.max_patterns > 0 && limited_.empty()) limit_patterns(current.point, table, start, columns);
    if (!limited_.empty()) {
        std::fill(sweeps.allowed.begin(), sweeps.allowed.end(), false);
        for (const std::size_t pattern : limited_) sweeps.allowed[column_of(pattern)] = true;
    }
    for (int proposal = 0; proposal < kMostProposals && radius >= kLeastRadius; ++proposal) {
        options_.control.check();
        sweeps.radius = radius;
        sweeps.seed = options_.seed + static_cast<std::uint64_t>(100 * round + proposal);
        const Choice choice = sweep(table, start, sweeps);
        const double promised = current.trial.objective - choice.objective;
        const bool is_too_heavy =
            options_.max_mass > 0.0 && trials_.mass_of(current.point) > options_.max_mass;
        if (!is_too_heavy && !(promised > kLeastGain * current.trial.objective)) return false;
        Point next = current.point;
        for (std::size_t g = 0; g < start.size(); ++g) next.patterns[g] = columns[choice.columns[g]];
        next.unknowns += choice.steps;
        Trial trial = trials_.solve(next, options_.control);
        const double gained = trial.is_found ? current.trial.objective - trial.objective : -1.0;
        if (gained > kLeastGain * current.trial.objective || (is_too_heavy && trial.is_found)) {
            if (gained > 0.75 * promised) radius = std::min(kLargestRadius, 2.0 * radius);
            if (gained < 0.25 * promised) radius *= 0.5;
            current = {std::move(next), std::move(trial)};
            tell(current);
            return true;
        }
        radius = 0.25 * std::min(radius, choice.energy / table.energy);
        if (trials_.solutions() >= options_.most_solutions) return false;
    }
    return false;
}

Solved Search::improve(Solved start, double reserve) {
    Solved current = std::move(start);
    double radius = kFirstRadius;
    int failures = 0;
    // Tables are of the last equilibrium.
    for (int round = 0; may_go_on(reserve); ++round) {
        if (current.trial.objective <= kReached) {
            end_ = DesignEnd::NoSwapImproves;
            return current;
        }
        if (failures > 0 || round == 0) {
            current.trial = trials_.solve(current.point, options_.control);
            if (!current.trial.is_found) break;
        }
        const double before = watch_.seconds();
        const bool is_better = step(current, radius, round);
        step_seconds_ = std::max(step_seconds_, watch_.seconds() - before);
        if (is_better) {
            failures = 0;
            continue;
        }
        // Once more with other patterns, if there are any.
        radius = std::max(radius, 0.05);
        if (++failures >= (limited_.empty() && all_.size() > shortlist_.size() ? 2 : 1)) {
            end_ = DesignEnd::NoSwapImproves;
            return current;
        }
    }
    end_ = watch_.has_left(reserve + step_seconds_) ? DesignEnd::SolutionsSpent : DesignEnd::TimeSpent;
    return current;
}

/// A painting with some of its groups painted at random.
Point Search::kicked(const Point& point, std::uint64_t number) const {
    base::SplitMix64 random(base::SplitMix64::mix(options_.seed) ^ base::SplitMix64::mix(number));
    const std::vector<std::size_t>& patterns = limited_.empty() ? shortlist_ : limited_;
    Point kicked = point;
    const std::size_t changes = std::max<std::size_t>(
        1, static_cast<std::size_t>(kKickedShare * static_cast<double>(point.patterns.size())));
    for (std::size_t i = 0; i < changes; ++i)
        kicked.patterns[random.below(point.patterns.size())] = patterns[random.below(patterns.size())];
    return kicked;
}

Solved Search::improve_from_others(Solved best, const std::vector<Solved>& starts, double reserve) {
    const DesignEnd end = end_;
    const auto has_budget = [&] {
        return may_go_on(reserve) && trials_.solutions() + kLeftForDefect < options_.most_solutions &&
               best.trial.objective > kReached;
    };
    const auto try_from = [&](const Solved& start) {
        const Solved found = improve(start, reserve);
        report_.starts.push_back(std::sqrt(found.trial.objective));
        if (found.trial.is_found && found.trial.objective < best.trial.objective) best = found;
    };
    for (std::size_t i = 1; i < std::min(starts.size(), kOtherStarts) && has_budget(); ++i)
        try_from(starts[i]);
    for (std::uint64_t kick = 0; kick < kMostKicks && has_budget(); ++kick) {
        Solved start{kicked(best.point, kick), {}};
        start.trial = trials_.solve(start.point, options_.control);
        if (start.trial.is_found) try_from(start);
    }
    end_ = end;
    return best;
}

}  // namespace fretwork::design::detail
