// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/pattern/fan.hpp>
#include <fretwork/reduction/scenarios/setting.hpp>

#include <span>
#include <vector>

namespace fretwork::reduction {

/// How far the joints reach along each edge of a fan: both ends together, in widths of a bar.
///
/// At an end, the outlines of a bar and of its neighbour, an angle a away, part at cot(a / 2) / 2 widths from
/// the node; of the two neighbours the one that parts later counts. Neighbours at half a turn or more part at
/// once. Beyond a side of the polygon the same tile counts as neighbour, turned by half a turn about the
/// side's middle, as it lies in a regular surface of one pattern.
std::vector<double> joint_reaches(const pattern::Fan& fan, std::span<const geometry::Point2> places);

/// A bar between two nodes.
struct BarPlace {
    double length = 0.0;       ///< m, of the centreline
    double joint_reach = 0.0;  ///< of joint_reaches()
};

/// Section and material of the beam that stands for a bar.
///
/// With Joints::Stiff it is as stiff as a bar that is rigid at its ends, within kStiffShare of the joints'
/// reach: in stretching and torsion by the length L over the elastic length l, in bending in the plane by its
/// cube, which is exact for ends that move sideways without turning. Bending out of the plane stays: bars
/// that lie side by side in a joint are no stiffer in it than one by one. The mass stays, too.
TileMaterial bar_of(const Setting& setting, const BarPlace& place);

/// The share of the joints' reach that is rigid, and the least elastic share of a bar. Both by comparison
/// with solids (experiments/joints).
inline constexpr double kStiffShare = 0.35;
inline constexpr double kLeastElasticShare = 0.5;

}  // namespace fretwork::reduction
