// SPDX-License-Identifier: GPL-3.0-or-later
// What the tests of outlines share.
#pragma once

#include "support.hpp"

#include <fretwork/tiling/outline.hpp>

#include <algorithm>

namespace fretwork::tiling {

inline std::filesystem::path data_file(const std::string& name) {
    return std::filesystem::path(FRETWORK_SOURCE_DIR) / "tests/tiling/data" / name;
}

inline std::filesystem::path example_outline(const std::string& name) {
    return std::filesystem::path(FRETWORK_SOURCE_DIR) / "experiments/outlines" / name;
}

/// The area of an outline, its holes left out.
inline double area_of(const Outline& outline) {
    double area = pattern::signed_area(outline.boundary);
    for (const pattern::Polygon& hole : outline.holes) area += pattern::signed_area(hole);
    return area;
}

/// The lower left and the upper right corner of a polygon's box.
inline std::array<pattern::Point2, 2> box_of(const pattern::Polygon& polygon) {
    std::array<pattern::Point2, 2> box = {polygon.front(), polygon.front()};
    for (const pattern::Point2& p : polygon) {
        box[0] = {std::min(box[0].x, p.x), std::min(box[0].y, p.y)};
        box[1] = {std::max(box[1].x, p.x), std::max(box[1].y, p.y)};
    }
    return box;
}

}  // namespace fretwork::tiling
