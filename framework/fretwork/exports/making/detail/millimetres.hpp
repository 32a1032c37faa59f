// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers in the files of machines.
#pragma once

#include <charconv>
#include <cmath>
#include <string>

namespace fretwork::exports::detail {

/// Append the shortest text of a number that is rounded to 1e-6.
inline void append_rounded(std::string& text, double value) {
    char buffer[32];
    const double rounded = std::round(value * 1e6) / 1e6;
    const auto result = std::to_chars(buffer, buffer + sizeof(buffer), rounded == 0.0 ? 0.0 : rounded,
                                      std::chars_format::fixed);
    text.append(buffer, result.ptr);
}

/// Append a length (m) in millimetres, rounded to a nanometre.
inline void append_millimetres(std::string& text, double metres) {
    append_rounded(text, 1e3 * metres);
}

/// A length (m) in millimetres, rounded to a nanometre, as text without a unit.
inline std::string millimetre_number(double metres) {
    std::string text;
    append_millimetres(text, metres);
    return text;
}

}  // namespace fretwork::exports::detail
