// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace fretwork::base {

/// Read a length as a person writes it: "26mm", "2.6 cm", "0.026m" or "0.026" (metres). Returns metres.
/// Throws InputError on anything else, NaN and infinity included.
double parse_length(std::string_view text);

/// Read an angle as a person writes it: "15", "15deg" or "0.26rad"; a bare number is in degrees. Returns
/// radians. Throws InputError on anything else, NaN and infinity included.
double parse_angle(std::string_view text);

/// Read a finite number. Throws InputError on anything else, trailing characters included.
double parse_number(std::string_view text);

}  // namespace fretwork::base
