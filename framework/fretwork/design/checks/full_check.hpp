// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/design/design.hpp>
#include <fretwork/design/search/trials.hpp>

#include <optional>
#include <vector>

namespace fretwork::design::detail {

/// The solution of the full model at a point of the search space, on the stable path from flat.
struct FullCheck {
    bool is_found = false;
    TargetError error;
    std::vector<mechanics::NodeValues>
        displacements{};  ///< displacements of all nodes, interface nodes first, for each load case
    std::optional<double> largest_utilization{};
    std::optional<double> utilization_error{};  ///< DesignReport::utilization_error
    int solutions = 0;
};

/// The choice whether to compute the largest utilization of the beams, and to estimate its error.
enum class BeamDemand { None, Utilization, UtilizationAndError };

/// The shapes of the surface in a check, with the places at which the goals want their nodes.
std::vector<CaseShape> shapes_of(const Trials& trials, const FullCheck& check);

/// Solve all load cases with all beams. Throws Stopped.
FullCheck check_in_full(const Trials& trials, const Point& point, BeamDemand beams,
                        const base::Control& control);

}  // namespace fretwork::design::detail
