// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/pattern/fan.hpp>
#include <fretwork/reduction/scenarios/setting.hpp>

#include <span>
#include <vector>

namespace fretwork::reduction {

/// The length of each edge of a fan that lies within joints: the sum of both ends, in widths of a bar.
///
/// The outlines of a bar and of its neighbour at an angle a separate at cot(a / 2) / 2 widths from their
/// node. A joint reaches to where the bar has separated from both neighbours. At an angle of half a turn or
/// more, two bars separate at the node itself. At a side of the polygon, the neighbouring tile is taken as
/// the same tile, turned by half a turn about the side's middle, as in a regular surface of one pattern.
std::vector<double> joint_reaches(const pattern::Fan& fan, std::span<const geometry::Point2> places);

/// A bar between two nodes.
struct BarPlace {
    double length = 0.0;       ///< m, of the centreline
    double joint_reach = 0.0;  ///< the value from joint_reaches(), in widths of a bar
};

/// The section and material of the beam that models a bar.
///
/// With Joints::Stiff, the beam is as stiff as a bar with rigid ends, whose rigid length is kStiffShare of
/// the joints' reach. Let L be the bar's length and l its elastic length. Stiffness in stretching and torsion
/// grows by L / l, and in bending in the plane by (L / l)^3, which is exact for ends that move sideways
/// without turning. Bending out of the plane keeps its stiffness, because bars side by side in a joint are
/// together no stiffer than one by one. The mass stays, too.
TileMaterial bar_of(const Setting& setting, const BarPlace& place);

/// The rigid share of the joints' reach, and the least elastic share of a bar. Both come from a comparison
/// with solids (experiments/joints).
inline constexpr double kStiffShare = 0.35;
/// The least share of a bar that stays elastic.
inline constexpr double kLeastElasticShare = 0.5;

}  // namespace fretwork::reduction
