// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/geometry/polygon.hpp>

#include <cstdio>
#include <string>

/// Lengths and places in messages: six digits, as a person reads them.
namespace fretwork::geometry {

inline std::string short_number(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.6g", value);
    return text;
}
/// For lengths that a person is to type.
inline std::string two_digits(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.2g", value);
    return text;
}
inline std::string metres(double length) {
    return short_number(length) + " m";
}
inline std::string place_text(Point2 place) {
    return "(" + short_number(place.x) + ", " + short_number(place.y) + ")";
}

}  // namespace fretwork::geometry
