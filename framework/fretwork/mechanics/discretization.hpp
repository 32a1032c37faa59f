// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/frame/frame.hpp>
#include <fretwork/mechanics/paths/equilibrium.hpp>

#include <span>
#include <vector>

namespace fretwork::mechanics {

/// The frame with the number of elements of each beam multiplied by `times`. Throws InputError if `times` is
/// below one, or if a beam would get more than kMostDivisions elements.
Frame refined(Frame frame, int times);

/// An estimate of the difference between a solution and the limit of ever finer divisions. Each value is the
/// largest over the frame's nodes.
struct DiscretizationError {
    double displacement = 0.0;  ///< largest error of a displacement, m
    double rotation = 0.0;      ///< largest error of a rotation, rad
    /// The larger of two relative errors. One is `displacement` over the largest displacement. The other is
    /// `rotation` over the largest rotation, which is taken as at least the largest displacement divided by
    /// the frame's extent.
    double share = 0.0;
    /// False if one of the two solutions did not converge, if the two solutions are too far apart to lie on
    /// one branch, or if the divisions can be neither halved nor doubled (kMostDivisions).
    bool known = false;
    friend bool operator==(const DiscretizationError&, const DiscretizationError&) = default;
};

/// The ratio of a solution's error to its difference from the solution with twice as many divisions:
/// 1 / (1 - 2^-2), if the error falls with the square of the elements' length.
inline constexpr double kErrorFromFiner = 4.0 / 3.0;

/// Estimate the discretization error of each solution of a load path (Richardson extrapolation) by following
/// the path again with other divisions. If the divisions of all beams are even, the second path has half as
/// many divisions, and costs about half as much as the first. Otherwise the second path has twice as many
/// divisions, and costs twice as much. The elements converge with order four in a plane or if sections bend
/// equally about both axes, and with order two otherwise or with shear. The estimate assumes order two. If
/// one of the two paths has one element for each beam, errors of opposite sign can cancel, and the estimate
/// can be several times too small. Throws InputError if the numbers of solutions and load factors differ, and
/// as assemble() and follow_load_path().
///
/// @param solutions  the solutions of follow_load_path() for assemble(frame) and these load factors
std::vector<DiscretizationError> estimate_discretization_error(const Frame& frame,
                                                               std::span<const double> load_factors,
                                                               std::span<const Solution> solutions,
                                                               const EquilibriumOptions& options = {});

}  // namespace fretwork::mechanics
