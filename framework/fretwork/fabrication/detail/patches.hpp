// SPDX-License-Identifier: GPL-3.0-or-later
// Material before it is united: rectangles along bars, and round ends around nodes.
#pragma once

#include <fretwork/fabrication/bar_plan.hpp>

#include <optional>
#include <set>
#include <span>
#include <vector>

namespace fretwork::fabrication::detail {

struct Disc {
    geometry::Point2 center;
    double radius = 0.0;  ///< m
};

/// A convex polygon of material. Where it has arcs, its corners lie on their circle.
struct Patch {
    geometry::Polygon polygon;
    std::optional<Disc> disc{};
    geometry::Box box;
};

/// The angle between neighbouring corners on a circle, rad. If a line cuts a chord, with_arcs() still lets
/// the arc end on that line. Openings smaller than a chord's sagitta, 1.25e-3 of the radius, are lost.
inline constexpr double kChordAngle = 0.1;

/// The material of bars that are wider by `growth` (m): all places within half a width of a bar's line. Each
/// bar gives a rectangle. If neighbouring bars of one width at a node enclose more than half a turn, the
/// circle around the node is added.
std::vector<Patch> bar_patches(const BarPlan& plan, double growth);

Patch disc_patch(const Disc& disc);

/// The discs that meet the box around a polygon.
std::vector<Disc> near_discs(const geometry::Polygon& polygon, const std::vector<Disc>& discs);

/// The nodes where bars end, and the other nodes at the same places.
std::set<TessellationNodeIndex> nodes_with_bars(const BarPlan& plan);
/// Check that a bar ends at each node with a hole for a bolt. Throws InputError.
void require_bars_at_bolts(const BarPlan& plan, std::span<const TessellationNodeIndex> bolts);

}  // namespace fretwork::fabrication::detail
