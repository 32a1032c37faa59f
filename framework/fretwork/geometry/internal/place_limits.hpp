// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/limits.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/geometry/polygon.hpp>

#include <string>

/// Places in inputs. Both coordinates of a place lie within base::kLengthLimits.
namespace fretwork::geometry {

/// True if both coordinates lie within the limits. False for NaN.
inline bool is_within_limits(Point2 place) {
    return base::is_within(place.x, base::kLengthLimits) && base::is_within(place.y, base::kLengthLimits);
}
/// A place with all of its digits: "(0.1, nan)".
inline std::string exact_place_text(Point2 place) {
    return "(" + base::format_number(place.x) + ", " + base::format_number(place.y) + ")";
}
/// The complaint about a place beyond the limits, which `name` names: "point 3 is (0.1, nan), where each
/// coordinate must be a number from -1e+12 to 1e+12 (m)".
inline std::string beyond_limits_text(const std::string& name, Point2 place) {
    return name + " is " + exact_place_text(place) + ", where each coordinate must be " +
           base::range_text(base::kLengthLimits);
}

}  // namespace fretwork::geometry
