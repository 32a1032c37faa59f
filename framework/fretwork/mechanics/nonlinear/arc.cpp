// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/mechanics/nonlinear/arc.hpp>

#include <algorithm>

namespace fretwork::mechanics::nonlinear {
namespace {

/// The shortest step along the path, in rad or element lengths, and as a share of the first step. A step is
/// too short only if it is shorter than both.
constexpr double kShortestMove = 1e-10;
constexpr double kShortestShare = 1e-9;
/// The share of the load below which a step is narrow. If every narrow step still crosses a change of
/// stability, the change belongs to this path. An imperfect load can turn a bifurcation into a sharp bend; a
/// narrow enough step follows the path around such a bend.
constexpr double kNarrowest = 1e-5;
/// The share of the load by which a step over a change of stability goes beyond the change.
constexpr double kBeyondChange = 1.0 / 64.0;

/// The largest ratio of a step's length to the length of the step before. The length is ideal if the step
/// deviates by the following share of the accepted deviation.
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

/// The length of a step that goes just over a change of stability, if the change is near.
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
