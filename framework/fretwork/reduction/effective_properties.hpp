// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/reduction/response.hpp>

#include <Eigen/Core>

#include <string>
#include <utility>
#include <vector>

namespace fretwork::reduction {

/// The stiffness and mass of the thin plate that is equivalent to an infinite, regular surface of one
/// pattern, at small displacements.
///
/// The tensors A and D are in Voigt's notation with engineering shear: A maps (e_xx, e_yy, 2 e_xy) to
/// membrane forces, D maps curvatures (w_xx, w_yy, 2 w_xy) to moments. Forces and moments are per unit of
/// length.
struct EffectiveProperties {
    Eigen::Matrix3d A;           ///< N/m
    Eigen::Matrix3d D;           ///< N m
    double mass_per_area = 0.0;  ///< kg/m^2
};

/// Homogenize a pattern in the setting's regular polygon. The polygon must have four or six sides, so that
/// each side of a tile meets the opposite side of the neighbouring tile.
///
/// The periodic cell is one tile: the pattern's frame, condensed onto its interface nodes. The nodes move by
/// the macroscopic strain (or curvature) plus a fluctuation, which is equal at opposite nodes and minimizes
/// the energy. The result is exact for the periodic frame. Throws InputError if the polygon has another
/// number of sides, and as pattern_frame() and condensed_frame(), for example if an interface node has no
/// beam.
EffectiveProperties effective_properties(const pattern::NodeLayout& layout, const pattern::Pattern& pattern,
                                         const Setting& setting);

/// The stiffness of a strip in the direction `angle` (rad, counterclockwise from x), in the unit of `tensor`,
/// which is A or D. The strip may contract freely across this direction.
double directional_stiffness(const Eigen::Matrix3d& tensor, double angle);

/// The named values that libraries store: membrane_stiffness (N/m), membrane_poisson, membrane_shear (N/m),
/// membrane_anisotropy (largest over smallest directional stiffness, in steps of one degree), the same four
/// names with bending_ (N m), mass_per_area (kg/m^2), and both tensors (A11 A12 A16 A22 A26 A66, D11 ..).
/// Stiffness and Poisson's ratio are taken in the direction x.
std::vector<std::pair<std::string, double>> property_values(const EffectiveProperties& properties);

}  // namespace fretwork::reduction
