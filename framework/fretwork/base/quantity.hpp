// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <charconv>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

namespace fretwork::base {

/// Parse a length as a person types it: "500um", "26mm", "2.6 cm", "0.026m" or "0.026" (metres). Returns
/// metres. Throws InputError on anything else, NaN and infinity included.
double parse_length(std::string_view text);

/// Parse a length above zero that a person typed as the option or entry `name`. Returns metres. Throws
/// InputError that names the option.
double parse_length_above_zero(const std::string& name, std::string_view text);

/// Refuse a length of at least `large` metres that has no unit, because its writer most likely meant
/// millimetres. Throws InputError that names the option or entry `name`.
void refuse_missing_unit(const std::string& name, const std::string& text, double large);

/// Parse an angle as a person types it: "15", "15deg" or "0.26rad"; a bare number is in degrees. Returns
/// radians. Throws InputError on anything else, NaN and infinity included.
double parse_angle(std::string_view text);

/// Parse a finite number, which spaces may follow. Throws InputError on anything else.
double parse_number(std::string_view text);

/// Read a text that is a number with at most one sign; a double may be infinite or NaN. Nothing if the text
/// is not a number, or if the number is outside the range of the type.
template <class Number>
std::optional<Number> read_number(std::string_view text) {
    if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
    Number number{};
    const char* last = text.data() + text.size();
    const auto [end, error] = std::from_chars(text.data(), last, number);
    if (error != std::errc() || end != last) return std::nullopt;
    return number;
}

}  // namespace fretwork::base
