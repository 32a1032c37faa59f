// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/nonlinear/path_step.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace fretwork::mechanics::nonlinear {

/// The progress along a path by its arc length: the last two states, the length of the next step, and the
/// place of the next change of stability, if it is known. Lengths are measured with the system's weights.
struct Arc {
    PathState state;
    std::optional<PathState> previous;
    double length = 0.0;  ///< length of the next step
    /// Distance along the path to a place beyond a change of stability; infinity: no change is known.
    double crossing = std::numeric_limits<double>::infinity();
    double beyond = 0.0;    ///< length of the step that first crossed the change
    double shortest = 0.0;  ///< length of the shortest step that is tried
    /// A lower bound on load_scale(): 0 for a path from rest, 1 for a path from another equilibrium, whose
    /// load factor is the share of a change of the load.
    double least_load_scale = 0.0;

    [[nodiscard]] const PathState* last() const { return previous ? &*previous : nullptr; }
    /// True if a step of this length changes the load so little that a change of stability within the step
    /// belongs to this path.
    [[nodiscard]] bool is_narrow(double step) const;
    /// Shorten the next step after a step of length `step` that crossed a change of stability. Returns false
    /// if the path is already near this change.
    bool come_nearer(double step);
    /// Set the length of the next step after a step that continues the path.
    void plan_next(const PathStep& step);
    void forget_crossing(double next_length);

    /// The reference load factor for small changes of the load.
    [[nodiscard]] double load_scale() const { return std::max(state.point.load_factor, least_load_scale); }

  private:
    [[nodiscard]] double length_to_crossing(double length) const;
};

/// Begin an arc at an equilibrium with a known rate, towards a larger load.
Arc begin_arc(const PathStepper& stepper, const PathPoint& point, double load_factor,
              double least_load_scale);

}  // namespace fretwork::mechanics::nonlinear
