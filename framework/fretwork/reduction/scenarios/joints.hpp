// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/pattern/fan.hpp>
#include <fretwork/reduction/scenarios/setting.hpp>

#include <span>
#include <vector>

namespace fretwork::reduction {

/// The joint reach of each edge of a fan, in widths of a bar: the total length of the edge within the joints
/// at its two ends.
///
/// If a bar and its neighbour meet at an angle a, their outlines separate at cot(a / 2) / 2 widths from their
/// node. At an angle of half a turn or more, they separate at the node itself. The joint ends where the bar
/// has separated from both neighbours. Beyond a side of the polygon, the neighbouring tile is taken to be the
/// same tile, turned by half a turn about the side's middle, as in a regular surface of one pattern.
///
/// @param places  positions of the fan's nodes, m, as from pattern::place_fan()
std::vector<double> joint_reaches(const pattern::Fan& fan, std::span<const geometry::Point2> places);

/// A bar between two nodes.
struct BarPlace {
    double length = 0.0;       ///< length of the centreline, m
    double joint_reach = 0.0;  ///< joint reach from joint_reaches(), in widths of a bar
};

/// The section and material of the beam that models a bar.
///
/// With Joints::Stiff, the beam is as stiff as a bar with two rigid ends. The total rigid length is
/// kStiffShare times the joint reach. Let L be the bar's length and l the length of its elastic rest, at
/// least kLeastElasticShare times L. The stiffness in stretching, torsion and in-plane shear grows by the
/// factor L / l. The stiffness in in-plane bending grows by the factor (L / l)^3, which is exact for ends
/// that move sideways without turning. The stiffness in out-of-plane bending and shear does not change,
/// because bars side by side in a joint are together no stiffer than one by one. The mass does not change
/// either.
TileMaterial bar_of(const Setting& setting, const BarPlace& place);

/// The rigid share of the joint reach, from a comparison with solids (experiments/joints).
inline constexpr double kStiffShare = 0.35;
/// The smallest elastic share of a bar's length, from the same comparison.
inline constexpr double kLeastElasticShare = 0.5;

}  // namespace fretwork::reduction
