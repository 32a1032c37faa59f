// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/random.hpp>
#include <fretwork/design/search/search.hpp>
#include <fretwork/design/swaps/relaxed_choice.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

namespace fretwork::design::detail {
namespace {

constexpr double kFirstRadius = 0.5;
constexpr double kLeastRadius = 1e-5;
constexpr double kLargestRadius = 4.0;
/// Proposals of one table, each with a smaller radius.
constexpr int kMostProposals = 4;
/// A step must be predicted to gain more than this share of the objective.
constexpr double kLeastGain = 0.005;
/// A step from another start must be predicted to gain this, except on small surfaces.
constexpr double kWorthwhileGain = 0.02;
/// The number of solved paintings from which the search starts, with the first one; then the largest number
/// of starts from the best painting, and the share of its groups that is painted at random.
constexpr std::size_t kMostStarts = 3;
constexpr std::uint64_t kMostKicks = 100;
constexpr double kKickedShare = 0.2;
/// The share on small surfaces, where search_nearby() covers changes of two groups.
constexpr double kKickedShareOfSmall = 0.45;
/// The share of the solutions that is left for the defect correction, and their largest number.
constexpr double kLeftForDefect = 0.35;
constexpr int kMostLeftForDefect = 14;
/// Below kSmallSurface groups, the number of solutions grows in inverse proportion to that of the groups, at
/// most by kMostFactor.
constexpr double kSmallSurface = 44.0;
constexpr double kMostFactor = 8.0;
constexpr int kSolutions = 40;
/// A start is given up if its table predicts more than this multiple of the best objective.
constexpr double kHopelessPromise = 1.3;

/// The radius of the next step: larger if this one gained what was promised, smaller if it gained little of
/// it.
double adapted(double radius, double gained, double promised) {
    if (gained > 0.75 * promised) radius = std::min(kLargestRadius, 2.0 * radius);
    if (gained < 0.25 * promised) radius *= 0.5;
    return radius;
}

}  // namespace

std::vector<std::size_t> places_of(const std::vector<std::size_t>& patterns,
                                   const std::vector<std::size_t>& columns) {
    std::vector<std::size_t> places;
    for (const std::size_t pattern : patterns)
        places.push_back(
            static_cast<std::size_t>(std::ranges::lower_bound(columns, pattern) - columns.begin()));
    return places;
}

Point painted(Point point, const Choice& choice, const std::vector<std::size_t>& columns) {
    for (std::size_t g = 0; g < choice.columns.size(); ++g) point.patterns[g] = columns[choice.columns[g]];
    return point;
}

int solution_limit(const DesignOptions& options, std::size_t groups) {
    if (options.most_solutions > 0) return options.most_solutions;
    const double tiles = static_cast<double>(std::max<std::size_t>(1, groups));
    return static_cast<int>(kSolutions * std::clamp(kSmallSurface / tiles, 1.0, kMostFactor));
}

Search::Search(Trials& trials, const DesignOptions& options, const TimeLimit& time, DesignReport& report)
    : trials_(trials),
      options_(options),
      time_(time),
      report_(report),
      most_solutions_(solution_limit(options, trials.parts().groups.size())) {}

void Search::set_columns(std::vector<std::size_t> shortlist, std::vector<std::size_t> all) {
    shortlist_ = std::move(shortlist);
    all_ = std::move(all);
}

bool Search::may_solve() const {
    return trials_.solutions() + static_cast<int>(trials_.parts().cases.size()) <= most_solutions_;
}

bool Search::may_go_on(double reserve) const {
    return may_solve() && time_.has_left(reserve + step_seconds_);
}

bool Search::keeps_mass(const Point& point) const {
    return options_.max_mass <= 0.0 || trials_.mass_of(point) <= options_.max_mass;
}

bool Search::is_better(const Solved& own, const Solved& other) const {
    const bool is_light = keeps_mass(own.point);
    if (is_light != keeps_mass(other.point)) return is_light;
    return own.trial.objective < other.trial.objective;
}

void Search::begin_at(const Solved& start) {
    best_ = keeps_mass(start.point) ? start.trial.objective : -1.0;
    best_point_.reset();
}

void Search::note(const Solved& solved) {
    if (best_ >= 0.0 && solved.trial.objective >= best_) return;
    if (!keeps_mass(solved.point)) return;
    best_ = solved.trial.objective;
    best_point_ = solved.point;
    const DesignProgress progress{trials_.solutions(), most_solutions_, time_.seconds(), std::sqrt(best_)};
    report_.history.push_back(progress);
    if (options_.on_better) options_.on_better(progress);
}

/// The patterns of the painting, with max_patterns those of kept tiles, and others: those of `limited_` if
/// there are any, else the shortlist in even rounds, and as many at random in odd rounds.
std::vector<std::size_t> Search::columns_for(const Point& point, int round) const {
    std::set<std::size_t> chosen(point.patterns.begin(), point.patterns.end());
    if (options_.max_patterns > 0) {
        for (const std::size_t own : kept_candidates(trials_.parts().candidates,
                                                     trials_.parts().surface.tessellation, options_.keep)) {
            if (std::ranges::find(all_, own) != all_.end()) chosen.insert(own);
        }
    }
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

/// The part of the largest mass left for the groups, kg; zero: any mass.
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
    const std::set<std::size_t> kept =
        kept_candidates(trials_.parts().candidates, trials_.parts().surface.tessellation, options_.keep);
    const SweepOptions sweeps{.allowed = std::vector<bool>(columns.size(), true),
                              .radius = kLargestRadius,
                              .most_mass = mass_for_groups(point, table, start),
                              .seed = options_.seed,
                              .control = options_.control.silent()};
    // The patterns of the start stay, so that the start is allowed. Those of kept tiles count in any case,
    // and a pattern counts together with its mirror image.
    std::set<std::size_t> chosen(point.patterns.begin(), point.patterns.end());
    std::set<std::size_t> all = kept;
    for (const std::size_t own : chosen) all.insert({own, trials_.image_of(own)});
    for (const std::size_t own : kept) {
        if (all.contains(trials_.image_of(own)) && std::ranges::find(all_, own) != all_.end())
            chosen.insert(own);
    }
    const bool has_pairs =
        std::ranges::any_of(columns, [this](std::size_t own) { return trials_.image_of(own) != own; });
    const std::size_t left = options_.max_patterns - std::min(options_.max_patterns, all.size());
    if (const std::size_t most = left / (has_pairs ? 2 : 1); most > 0) {
        const auto allowed = fewer_columns(table, start, sweeps, most);
        for (std::size_t c = 0; c < columns.size(); ++c) {
            if (allowed[c]) chosen.insert(columns[c]);
        }
    }
    limited_.assign(chosen.begin(), chosen.end());
}

/// The columns whose patterns may be used.
std::vector<bool> Search::allowed_of(const std::vector<std::size_t>& columns) const {
    std::vector<bool> allowed(columns.size(), limited_.empty());
    for (const std::size_t place : places_of(limited_, columns)) allowed[place] = true;
    return allowed;
}

Search::Step Search::step(Solved& current, double& radius, int round, const Demand& demand) {
    const std::vector<std::size_t> columns = columns_for(current.point, round);
    const std::vector<std::size_t> start = places_of(current.point.patterns, columns);
    const SwapTable table =
        trials_.table(current.point, current.trial, columns,
                      options_.seed + static_cast<std::uint64_t>(round), options_.control);
    report_.swaps_scored += static_cast<long>(table.groups() * table.columns());
    if (options_.max_patterns > 0 && limited_.empty()) limit_patterns(current.point, table, start, columns);
    SweepOptions sweeps{.allowed = allowed_of(columns),
                        .most_mass = mass_for_groups(current.point, table, start),
                        .control = options_.control.silent()};
    const bool is_too_heavy = !keeps_mass(current.point);
    for (int proposal = 0; proposal < kMostProposals && radius >= kLeastRadius && may_solve(); ++proposal) {
        options_.control.check();
        sweeps.radius = radius;
        sweeps.seed = options_.seed + static_cast<std::uint64_t>(100 * round + proposal);
        const Choice choice = sweep(table, start, sweeps);
        report_.swaps_scored += choice.scored;
        const double promised = current.trial.objective - choice.objective;
        if (!is_too_heavy && !(promised > demand.gain * current.trial.objective)) return Step::NoBetter;
        if (round > 1 && demand.rival > 0.0 && choice.objective > kHopelessPromise * demand.rival)
            return Step::Hopeless;
        Point next = painted(current.point, choice, columns);
        next.unknowns = trials_.bounded(next.unknowns + choice.steps);
        radius = std::min(radius, kLargestRadius);
        Trial trial;
        if (!is_seen(next)) trial = solve(next);
        const double gained = trial.is_found ? current.trial.objective - trial.objective : -1.0;
        if (gained > 0.5 * demand.gain * current.trial.objective || (is_too_heavy && trial.is_found)) {
            radius = adapted(radius, gained, promised);
            current = {std::move(next), std::move(trial)};
            note(current);
            return Step::Better;
        }
        radius = 0.25 * std::min(radius, choice.energy / table.energy);
    }
    return Step::NoBetter;
}

bool Search::is_seen(const Point& point) const {
    return point.unknowns.size() == 0 && seen_.contains(point.patterns);
}

Trial Search::solve(const Point& point) {
    Trial trial = trials_.solve(point, options_.control);
    if (point.unknowns.size() == 0)
        seen_[point.patterns] = trial.is_found ? trial.objective : std::numeric_limits<double>::infinity();
    return trial;
}

bool Search::return_to(Solved& solved) {
    if (trials_.is_at(solved.point)) return true;
    Trial again = solve(solved.point);
    if (!again.is_found) return false;
    solved.trial = std::move(again);
    return true;
}

Solved Search::improve(Solved start, double reserve) {
    return descend(std::move(start), reserve, {kLeastGain, 0.0});
}

Solved Search::descend(Solved start, double reserve, const Demand& demand) {
    Solved current = std::move(start);
    double radius = kFirstRadius;
    int failures = 0;
    // The aims may have moved since the start was solved. If another point was solved since, the start is
    // solved again below, because tables are made at the last equilibrium.
    if (trials_.is_at(current.point))
        current.trial.objective = trials_.objective_of(current.trial.displacements);
    for (int round = 0; may_go_on(reserve); ++round) {
        if (current.trial.objective <= kReachedObjective) {
            end_ = DesignEnd::NoSwapImproves;
            return current;
        }
        if (!return_to(current)) {
            end_ = DesignEnd::NoSwapImproves;
            return current;
        }
        const double before = time_.seconds();
        const Step taken = step(current, radius, round, demand);
        step_seconds_ = std::max(step_seconds_, time_.seconds() - before);
        if (taken == Step::Better) {
            failures = 0;
            continue;
        }
        if (taken == Step::NoBetter && !may_solve()) break;
        // Once more with other patterns, if there are any.
        radius = std::max(radius, 0.05);
        const int most = limited_.empty() && all_.size() > shortlist_.size() ? 2 : 1;
        if (taken == Step::Hopeless || ++failures >= most) {
            end_ = DesignEnd::NoSwapImproves;
            return current;
        }
    }
    end_ = time_.has_left(reserve + step_seconds_) ? DesignEnd::SolutionsSpent : DesignEnd::TimeSpent;
    return current;
}

/// A painting with some of its groups painted at random.
Point Search::kicked(const Point& point, double share, std::uint64_t number) const {
    base::SplitMix64 random(base::SplitMix64::mix(options_.seed) ^ base::SplitMix64::mix(number));
    const std::vector<std::size_t>& patterns = limited_.empty() ? shortlist_ : limited_;
    Point kicked = point;
    const std::size_t changes = std::max<std::size_t>(
        1, static_cast<std::size_t>(share * static_cast<double>(point.patterns.size())));
    for (std::size_t i = 0; i < changes; ++i)
        kicked.patterns[random.below(point.patterns.size())] = patterns[random.below(patterns.size())];
    return kicked;
}

double Search::relaxed_misfit(const Solved& solved) {
    const std::vector<std::size_t> columns = columns_for(solved.point, 0);
    const SwapTable table =
        trials_.table(solved.point, solved.trial, columns, options_.seed, options_.control);
    const auto start = places_of(solved.point.patterns, columns);
    return std::sqrt(relaxed_choice(table, start, options_.control.silent()).objective);
}

int Search::left_for_defect() const {
    return std::min(kMostLeftForDefect, static_cast<int>(kLeftForDefect * most_solutions_));
}

Solved Search::improve_from_others(Solved best, const std::vector<Solved>& starts, double reserve, int left) {
    const DesignEnd end = end_;
    const int last_solution = most_solutions_ - left;
    const auto has_budget = [&] {
        return may_go_on(reserve) && trials_.solutions() < last_solution &&
               best.trial.objective > kReachedObjective;
    };
    const auto try_from = [&](const Solved& start) {
        const double gain = is_small() ? kLeastGain : kWorthwhileGain;
        Solved found = descend(start, reserve, {gain, is_small() ? 0.0 : best.trial.objective});
        report_.start_misfits.push_back(std::sqrt(found.trial.objective));
        if (!found.trial.is_found || !is_better(found, best)) return false;
        best = std::move(found);
        return true;
    };
    for (std::size_t i = 1; i < std::min(starts.size(), kMostStarts) && has_budget(); ++i)
        (void)try_from(starts[i]);
    if (is_small()) best = search_nearby(std::move(best), reserve, last_solution);
    for (; kicks_ < kMostKicks && has_budget(); ++kicks_) {
        // On small surfaces every second start is all at random.
        const double share = !is_small() ? kKickedShare : kicks_ % 2 == 0 ? kKickedShareOfSmall : 1.0;
        Solved start{kicked(best.point, share, kicks_), {}};
        if (is_seen(start.point)) continue;
        start.trial = solve(start.point);
        if (start.trial.is_found && try_from(start) && is_small())
            best = search_nearby(std::move(best), reserve, last_solution);
    }
    end_ = end;
    return best;
}

}  // namespace fretwork::design::detail
