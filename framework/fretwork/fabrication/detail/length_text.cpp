// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/text.hpp>
#include <fretwork/fabrication/detail/length_text.hpp>

#include <cmath>

namespace fretwork::fabrication::detail {

std::string short_number(double value) {
    return base::format_number(value, 4);
}

std::string millimetres(double metres) {
    return short_number(1e3 * metres) + " mm";
}

std::string place_text(geometry::Point2 place) {
    const auto text = [](double metres) { return base::format_number(std::round(metres * 1e5) / 100.0); };
    return "(" + text(place.x) + ", " + text(place.y) + ") mm";
}

}  // namespace fretwork::fabrication::detail
