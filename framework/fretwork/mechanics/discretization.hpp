// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/frame/frame.hpp>
#include <fretwork/mechanics/paths/equilibrium.hpp>

#include <span>
#include <vector>

namespace fretwork::mechanics {

/// The frame with `times` as many elements in every beam. Throws InputError if `times` is below one.
Frame refined(Frame frame, int times);

/// An estimate of the distance of a solution from the limit of ever finer divisions. Each value is the
/// largest over the frame's nodes.
struct DiscretizationError {
    double displacement = 0.0;  ///< metres
    double rotation = 0.0;      ///< rad
    /// The larger of two relative errors: that of displacements over the largest displacement, and that of
    /// rotations over the largest rotation. The latter is taken as at least the largest displacement divided
    /// by the frame's extent.
    double share = 0.0;
    bool known = false;  ///< false if one of the two solutions did not converge or does not exist, or if they
                         ///< are too far apart to lie on one branch
    friend bool operator==(const DiscretizationError&, const DiscretizationError&) = default;
};

/// Estimate the discretization error of each solution of a load path (Richardson extrapolation) by following
/// the path again with other divisions. If the divisions of all beams are even, it takes half as many, at
/// about half the cost of the path. Otherwise it takes twice as many, at twice the cost. The elements
/// converge with order four if sections bend equally about both axes, and with order two otherwise. The
/// estimate assumes order two, which is on the safe side. With one element for each beam, errors of opposite
/// sign can cancel, so an estimate can be too small by a factor of a few if one of the two solutions has one
/// division.
///
/// @param solutions  the solutions that follow_load_path gave for these load factors
std::vector<DiscretizationError> estimate_discretization_error(const Frame& frame,
                                                               std::span<const double> load_factors,
                                                               std::span<const Solution> solutions,
                                                               const EquilibriumOptions& options = {});

}  // namespace fretwork::mechanics
