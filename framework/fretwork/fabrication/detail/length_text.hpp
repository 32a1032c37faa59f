// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/geometry/polygon.hpp>

#include <string>

namespace fretwork::fabrication::detail {

/// At most four digits.
std::string short_number(double value);
/// "0.15 mm"
std::string millimetres(double metres);
/// "(12.5, 3) mm"
std::string place_text(geometry::Point2 place);

}  // namespace fretwork::fabrication::detail
