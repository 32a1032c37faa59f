// SPDX-License-Identifier: GPL-3.0-or-later
// Lists of numbers and places, as messages have them.
#pragma once

#include <fretwork/base/internal/json_text.hpp>
#include <fretwork/geometry/polygon.hpp>

#include <span>
#include <vector>

namespace fretwork::studio {

/// The values of indices.
template <class Index>
base::Json numbers_json(const std::vector<Index>& indices) {
    base::Json list = base::Json::array();
    for (const Index index : indices) list.push_back(index.value);
    return list;
}

/// The coordinates of points, as pairs [x, y].
inline base::Json points_json(std::span<const geometry::Point2> places) {
    base::Json list = base::Json::array();
    for (const geometry::Point2& place : places) list.push_back({place.x, place.y});
    return list;
}

}  // namespace fretwork::studio
