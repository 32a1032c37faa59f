// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/text.hpp>
#include <fretwork/fabrication/detail/plane.hpp>

namespace fretwork::fabrication::detail {

std::string place_text(const Point2& place) {
    const auto text = [](double metres) { return base::format_number(std::round(metres * 1e5) / 100.0); };
    return "(" + text(place.x) + ", " + text(place.y) + ") mm";
}

}  // namespace fretwork::fabrication::detail
