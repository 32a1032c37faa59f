// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/design/design.hpp>
#include <fretwork/design/search/trials.hpp>

#include <optional>
#include <vector>

namespace fretwork::design::detail {

/// The full model's solution at a point of the search space, on the path from flat or, if this loses
/// stability, on the stable branch.
struct FullCheck {
    bool has_converged = false;  ///< true if all equilibria were found; `error` says whether they are stable
    TargetError error;
    /// Displacements of each load case, interface nodes first.
    std::vector<mechanics::NodeValues> displacements{};
    std::optional<double> largest_utilization{};
    std::optional<double> utilization_error{};  ///< DesignReport::utilization_error
    int solutions = 0;
};

/// The quantities of the beams that a check computes: none, the largest utilization, or also its error. The
/// last two need a setting with a strength.
enum class BeamDemand { None, Utilization, UtilizationAndError };

/// Return the shape of the checked surface in each load case, with the wanted positions of the goals' nodes.
std::vector<CaseShape> shapes_of(const Trials& trials, const FullCheck& check);

/// Solve all load cases with the full model. If the path from flat loses stability, the solution continues on
/// the stable branch. Throws Stopped.
FullCheck check_in_full(const Trials& trials, const Point& point, BeamDemand beams,
                        const base::Control& control);

}  // namespace fretwork::design::detail
