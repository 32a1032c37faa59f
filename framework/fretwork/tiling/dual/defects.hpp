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

/// The defect in words: "the tiles would not be connected as the outline is".
std::string_view words_for(DefectKind kind);

struct Defect {
    DefectKind kind = DefectKind::Torn;
    geometry::Point2 place;
    std::vector<std::size_t> cells{};  ///< the cells with the defect, if it belongs to a cell or a side
};

/// The requirements on a tiling.
struct QualityLimits {
    /// Shortest side, as a share of the mean side of the tiles beside it, or of the largest wanted side if
    /// that is shorter.
    double side_share = 0.25;
    double smallest_side = 0.0;    ///< shortest side, m
    double smallest_angle = 0.44;  ///< smallest angle, rad; 25 degrees
    double covered_share = 0.98;   ///< smallest share of the outline's area to be covered
};

/// The comparison of a tiling with its outline.
struct Shape {
    std::vector<Defect> defects;
    double covered_share = 0.0;  ///< share of the outline's area that tiles cover
    double outside_share = 0.0;  ///< area of the tiles outside the outline, over the outline's area
};

/// Compare the tiles with the outline. Exact tests check that tiles are convex and share whole sides,
/// that at most two tiles share a side, and that sides connect all tiles. Exact tests also check that the
/// rim of the tiles is one simple curve for the boundary and one for each hole, and that these curves do not
/// cross. If all tests are passed, the tiles cover the inside of their rim exactly once and have the
/// outline's topology. Short sides, sharp angles and uncovered areas are tested in floating point. Throws
/// base::Stopped.
Shape compare_with_outline(const Dual& dual, const Rim& rim, const SizeField& field,
                           const QualityLimits& limits, const base::Control& control);

}  // namespace fretwork::tiling::detail
