// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/mechanics/nonlinear/arc.hpp>

#include <algorithm>

namespace fretwork::mechanics::nonlinear {
namespace {

/// rad, or element lengths: shorter steps along the path are not tried, and a change of stability is taken to
/// be one of this path if no step as long as the second of these passes round it. Where a load off the mode
/// has made a sharp bend out of a bifurcation, the path turns there.
constexpr double kShortestMove = 1e-7;
constexpr double kNarrowestMove = 1e-5;
/// The same as shares of the first step, where that moves less.
constexpr double kShortestShare = 1e-6;
constexpr double kNarrowestShare = 1e-3;
/// Share of the load by which a step over a change of stability goes beyond it.
constexpr double kBeyondChange = 1.0 / 64.0;

/// A step along the path may be this many times as long as the one before, and is as long as it can be if it
/// deviates by this share of what is accepted.
constexpr double kMostGrowth = 2.0;
constexpr double kGoodDeviation = 0.4;

}  // namespace

bool Arc::come_nearer(double step) {
    if (!std::isfinite(crossing)) beyond = step;
    if (crossing <= narrowest) return false;
    crossing = step;
    length = length_to_crossing(0.5 * step);
    return true;
}

void Arc::plan_next(const PathStep& step) {
    const double growth =
        std::clamp(std::sqrt(kGoodDeviation / std::max(step.deviation, 1e-3)), 0.5, kMostGrowth);
    length = growth * step.length;
    crossing -= step.length;
    if (crossing <= 0.0) crossing = std::numeric_limits<double>::infinity();
    if (std::isfinite(crossing)) length = length_to_crossing(std::min(length, 0.5 * crossing));
}

void Arc::forget_crossing(double next_length) {
    crossing = std::numeric_limits<double>::infinity();
    length = next_length;
}

/// Next to where stability changes, over it.
double Arc::length_to_crossing(double wanted) const {
    if (crossing > narrowest) return wanted;
    return std::clamp(kBeyondChange * state.point.load_factor / state.load_rate, crossing,
                      std::max(beyond, crossing));
}

Arc begin_arc(const PathStepper& stepper, const PathPoint& point, double load_factor) {
    Arc arc{stepper.rising(point), {}};
    arc.length = stepper.first_length(arc.state, load_factor);
    arc.shortest = std::min(stepper.length_of(arc.state, kShortestMove), kShortestShare * arc.length);
    arc.narrowest = std::min(stepper.length_of(arc.state, kNarrowestMove), kNarrowestShare * arc.length);
    return arc;
}

}  // namespace fretwork::mechanics::nonlinear
