// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/mechanics/nonlinear/arc.hpp>

#include <algorithm>

namespace fretwork::mechanics::nonlinear {
namespace {

/// rad, or element lengths: shorter steps along the path are not tried, unless they are more than this share
/// of the first step.
constexpr double kShortestMove = 1e-10;
constexpr double kShortestShare = 1e-9;
/// Share of the load: a change of stability is taken to be one of this path if no step that changes the load
/// by so little passes round it. Where a load off the mode has made a sharp bend out of a bifurcation, the
/// path turns there.
constexpr double kNarrowest = 1e-5;
/// Share of the load by which a step over a change of stability goes beyond it.
constexpr double kBeyondChange = 1.0 / 64.0;

/// A step along the path may be this many times as long as the one before, and is as long as it can be if it
/// deviates by this share of what is accepted.
constexpr double kMostGrowth = 2.0;
constexpr double kGoodDeviation = 0.4;

}  // namespace

bool Arc::is_narrow(double step) const {
    return step * state.load_rate <= kNarrowest * load_scale();
}

bool Arc::come_nearer(double step) {
    if (!std::isfinite(crossing)) {
        beyond = step;
    } else if (is_narrow(crossing)) {
        return false;
    }
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
    if (!is_narrow(crossing)) return wanted;
    return std::clamp(kBeyondChange * load_scale() / state.load_rate, crossing, std::max(beyond, crossing));
}

Arc begin_arc(const PathStepper& stepper, const PathPoint& point, double load_factor,
              double least_load_scale) {
    Arc arc{stepper.rising(point), {}};
    arc.least_load_scale = least_load_scale;
    arc.length = stepper.first_length(arc.state, load_factor);
    arc.shortest = std::min(stepper.length_of(arc.state, kShortestMove), kShortestShare * arc.length);
    return arc;
}

}  // namespace fretwork::mechanics::nonlinear
