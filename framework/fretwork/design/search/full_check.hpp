// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/design/design.hpp>
#include <fretwork/design/search/trials.hpp>

#include <optional>
#include <vector>

namespace fretwork::design::detail {

/// A point as the full model answers it, on the stable path from flat.
struct FullCheck {
    bool is_found = false;
    TargetError error;
    std::vector<mechanics::NodeValues> displacements{};  ///< of the interface nodes, of each load case
    std::optional<double> largest_utilization{};
    int solutions = 0;
};

/// What of the beams is asked for, too.
enum class BeamDemand { None, Utilization };

/// Throws Stopped.
FullCheck check_in_full(const Trials& trials, const Point& point, BeamDemand beams,
                        const base::Control& control);

}  // namespace fretwork::design::detail
