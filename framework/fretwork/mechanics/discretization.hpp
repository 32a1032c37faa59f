// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/frame/frame.hpp>
#include <fretwork/mechanics/paths/equilibrium.hpp>

#include <span>
#include <vector>

namespace fretwork::mechanics {

/// The same frame with every beam in `times` as many elements. Throws InputError if `times` is below one.
Frame refined(Frame frame, int times);

/// How far a solution is from that of endlessly fine divisions, by estimate: the largest over the frame's
/// nodes.
struct DiscretizationError {
    double displacement = 0.0;  ///< metres
    double rotation = 0.0;      ///< rad
    /// The error of the largest displacement, or of the largest rotation, whichever is worse. A rotation
    /// counts as no less than the largest displacement divided by the frame's extent.
    double share = 0.0;
    bool known = false;  ///< false: one of the two solutions has not converged or cannot be had, or they are
                         ///< too far apart to be on one branch
    friend bool operator==(const DiscretizationError&, const DiscretizationError&) = default;
};

/// Estimate the error of each solution of a load path by following it again (Richardson): with half the
/// divisions, at about half of the path's own cost, if those of all beams are even; else with twice as many,
/// at twice its cost. The elements' order is four for sections that bend equally about both axes and two
/// otherwise; the estimate assumes two, which errs on the safe side for the former. With one element
/// a beam, errors of either sign can cancel: an estimate with one division on its side can be too small by a
/// factor of a few.
///
/// @param solutions  of follow_load_path with these factors
std::vector<DiscretizationError> estimate_discretization_error(const Frame& frame,
                                                               std::span<const double> load_factors,
                                                               std::span<const Solution> solutions,
                                                               const EquilibriumOptions& options = {});

}  // namespace fretwork::mechanics
