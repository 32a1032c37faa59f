// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace fretwork::fabrication::detail {

/// With four digits.
std::string short_number(double value);
/// "0.15 mm"
std::string millimetres(double metres);

}  // namespace fretwork::fabrication::detail
