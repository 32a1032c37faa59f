// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/design/reach/unknown_fit.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>

namespace fretwork::design::detail {
namespace {

constexpr int kFirstSteps = 3;  // at most, for each of the kFitted paintings
constexpr int kMostSteps = 10;  // then for the best of them
constexpr int kMostHalvings = 3;
/// A step that gains less than this share of the objective ends the fit. Errors are compared only to 1 %.
constexpr double kSmallGain = 1e-3;
/// The largest number of uniform paintings that get their own best unknowns.
constexpr std::size_t kFitted = 4;
/// The share of a given time that the fit leaves for the search and the checks.
constexpr double kLeftForSearch = 0.4;
/// The largest factor by which a guess scales displacements.
constexpr double kMostGuessed = 5.0;

/// A guess of the unknowns that scales the displacements so that they come nearest to the target.
Point scaled_point(const Trials& trials, const Solved& own) {
    Point point = own.point;
    const FreeUnknowns& free = trials.parts().free;
    double all = 1.0;
    for (std::size_t c = 0; c < own.trial.displacements.size(); ++c) {
        const auto products = trials.parts().cases[c].goals.products(own.trial.displacements[c]);
        if (!(products.there > 0.0)) continue;
        const double multiple = std::clamp(products.both / products.there, 1.0 / kMostGuessed, kMostGuessed);
        if (free.factor) point.unknowns[trials.first_unknown(c)] *= multiple;
        all *= std::pow(multiple, 1.0 / static_cast<double>(own.trial.displacements.size()));
    }
    if (free.factor) return point;
    // Bending stiffness grows with the width, and with the third power of the thickness.
    const Eigen::Index section = trials.first_unknown(own.trial.displacements.size());
    if (free.thickness)
        point.unknowns[section + (free.width ? 1 : 0)] /= std::cbrt(all);
    else if (free.width)
        point.unknowns[section] /= all;
    point.unknowns = trials.bounded(point.unknowns);
    return point;
}

/// The guess, or `own` if that is no worse.
Solved guessed(Trials& trials, const Solved& own, const DesignOptions& options) {
    const Point point = scaled_point(trials, own);
    if (point == own.point) return own;
    Trial trial = trials.solve(point, options.control);
    if (!trial.is_found || trial.objective >= own.trial.objective) return own;
    return {point, std::move(trial)};
}

/// The step of all unknowns that the linearized surface asks for.
Eigen::VectorXd wanted_step(Trials& trials, const Solved& current, const DesignOptions& options) {
    const std::set<std::size_t> used(current.point.patterns.begin(), current.point.patterns.end());
    const std::vector<std::size_t> columns(used.begin(), used.end());
    const SwapTable table =
        trials.table(current.point, current.trial, columns, options.seed, options.control);
    return best_steps(table, table.residual);
}

/// What one fit may use.
struct FitLimits {
    int steps;
    std::function<bool()> may_solve;
};

/// The best values of the unknowns for a fixed painting, by Gauss-Newton steps. A step is halved until it
/// lowers the objective, at most kMostHalvings times.
Solved fit_unknowns(Trials& trials, Solved start, const DesignOptions& options, const FitLimits& limits) {
    Solved current = std::move(start);
    current.trial = trials.solve(current.point, options.control);  // tables are made at the last equilibrium
    for (int count = 0; count < limits.steps && current.trial.is_found; ++count) {
        Eigen::VectorXd step = wanted_step(trials, current, options);
        double gained = 0.0;
        for (int halving = 0; halving <= kMostHalvings && gained <= 0.0; ++halving, step *= 0.5) {
            if (!limits.may_solve()) return current;
            Point next = current.point;
            next.unknowns = trials.bounded(current.point.unknowns + step);
            Trial trial = trials.solve(next, options.control);
            if (!trial.is_found || trial.objective >= current.trial.objective) continue;
            gained = current.trial.objective - trial.objective;
            current = {std::move(next), std::move(trial)};
        }
        if (gained <= kSmallGain * current.trial.objective) return current;
    }
    return current;
}

}  // namespace

void fit_starts(Trials& trials, std::vector<Solved>& starts, const DesignOptions& options,
                const TimeLimit& time) {
    // Another factor or thickness nearly scales the displacements.
    std::ranges::stable_sort(starts, {},
                             [&](const Solved& own) { return trials.scaled_objective(own.trial); });
    const auto sort_by_mass = [&] {
        if (options.max_mass <= 0.0) return;
        std::ranges::stable_partition(
            starts, [&](const Solved& own) { return trials.mass_of(own.point) <= options.max_mass; });
    };
    sort_by_mass();
    const auto may_solve = [&] {
        return trials.solutions() < options.most_solutions && time.has_left(kLeftForSearch * options.seconds);
    };
    const auto fit = [&](Solved& start, int steps) {
        if (!may_solve()) return;
        Solved fitted = fit_unknowns(trials, start, options, {steps, may_solve});
        if (fitted.trial.is_found) start = std::move(fitted);
    };
    const auto sort = [&] {
        std::ranges::stable_sort(starts, {}, [](const Solved& own) { return own.trial.objective; });
        sort_by_mass();
    };
    for (std::size_t i = 0; i < std::min(starts.size(), kFitted) && may_solve(); ++i) {
        starts[i] = guessed(trials, starts[i], options);
        fit(starts[i], kFirstSteps);
    }
    sort();
    fit(starts.front(), kMostSteps);
    sort();
}

}  // namespace fretwork::design::detail
