// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/text.hpp>
#include <fretwork/geometry/polygon.hpp>

#include <string>

/// Lengths and places in messages: six digits, as a person reads them.
namespace fretwork::geometry {

inline std::string short_number(double value) {
    return base::format_number(value, 6);
}
inline std::string metres(double length) {
    return short_number(length) + " m";
}
inline std::string place_text(Point2 place) {
    return "(" + short_number(place.x) + ", " + short_number(place.y) + ")";
}

}  // namespace fretwork::geometry
