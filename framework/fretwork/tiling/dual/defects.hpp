// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/outlines/outline.hpp>
#include <fretwork/tiling/dual/dual.hpp>
#include <fretwork/tiling/remeshing/size_field.hpp>

#include <string_view>
#include <vector>

namespace fretwork::tiling::detail {

/// The possible defects of a tiling.
enum class DefectKind { TooNarrow, TooMany, Torn, NotConvex, Uncovered, ShortSide, SharpAngle };

/// In words: "the tiles would not be connected as the outline is".
std::string_view words_for(DefectKind kind);

struct Defect {
    DefectKind kind = DefectKind::Torn;
    geometry::Point2 place;
    std::vector<std::size_t> cells{};  ///< that have it, if it is one of a cell or a side
};

/// The requirements on a tiling.
struct QualityLimits {
    double side_share = 0.25;      ///< of the tiles' mean side there, or of the side wanted if that is less
    double smallest_side = 0.0;    ///< m
    double smallest_angle = 0.44;  ///< rad; 25 degrees
    double covered_share = 0.98;   ///< of the outline's area
};

/// How a tiling keeps the shape of its outline.
struct Shape {
    std::vector<Defect> defects;
    double covered_share = 0.0;  ///< of the outline's area
    double outside_share = 0.0;  ///< area of the tiles outside of the outline, over the outline's area
};

/// Compare the tiles with the outline. Decided exactly: tiles are convex, share whole sides, two tiles at
/// most a side, and are connected by sides; their rim is one simple curve for the boundary and one for each
/// hole, and none crosses another. So the tiles cover their rim's inside once, and have the outline's
/// topology.
Shape compare_with_outline(const Dual& dual, const Rim& rim, const SizeField& field,
                           const QualityLimits& limits, const base::Control& control);

}  // namespace fretwork::tiling::detail
