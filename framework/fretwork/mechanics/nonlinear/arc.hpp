// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/nonlinear/path_step.hpp>

#include <cmath>
#include <limits>
#include <optional>

namespace fretwork::mechanics::nonlinear {

/// Where a path is followed from along its arc, how far the next step goes, and what is known of what lies
/// ahead. Lengths are against the system's weights.
struct Arc {
    PathState state;
    std::optional<PathState> previous;
    double length = 0.0;                                        ///< of the next step
    double crossing = std::numeric_limits<double>::infinity();  ///< to where stability has changed
    double beyond = 0.0;                                        ///< the step that has first shown it
    double shortest = 0.0;                                      ///< no shorter steps are tried

    [[nodiscard]] const PathState* last() const { return previous ? &*previous : nullptr; }
    /// Whether a step of a length changes the load so little that what it crosses is on this path.
    [[nodiscard]] bool is_narrow(double step) const;
    /// A step has crossed a change of stability: come nearer to it with the next one. False if it is near.
    bool come_nearer(double step);
    /// The length of the step after one that continues the path.
    void plan_next(const PathStep& step);
    void forget_crossing(double next_length);

  private:
    [[nodiscard]] double length_to_crossing(double length) const;
};

/// Begin at an equilibrium with a known rate, towards a larger load.
Arc begin_arc(const PathStepper& stepper, const PathPoint& point, double load_factor);

}  // namespace fretwork::mechanics::nonlinear
