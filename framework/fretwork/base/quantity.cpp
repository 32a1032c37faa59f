// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/quantity.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>
#include <span>
#include <string>

namespace fretwork::base {
namespace {

struct Unit {
    std::string_view name;
    double factor = 1.0;
    int power = 0;  ///< power of ten; 0: the factor counts
};

constexpr Unit kLengths[] = {{""}, {"um", 1.0, -6}, {"mm", 1.0, -3}, {"cm", 1.0, -2}, {"m"}};
constexpr Unit kAngles[] = {{"", std::numbers::pi / 180}, {"deg", std::numbers::pi / 180}, {"rad", 1.0}};
constexpr Unit kNone[] = {{""}};

/// The number times a power of ten, rounded once: 26mm gives the double nearest to 0.026, and 26 * 0.001
/// does not.
double shifted(std::string_view number, int power) {
    const std::size_t mark = std::min(number.find_first_of("eE"), number.size());
    int exponent = 0;
    if (mark < number.size()) {
        const char* digits = number.data() + mark + 1;
        std::from_chars(*digits == '+' ? digits + 1 : digits, number.data() + number.size(), exponent);
    }
    const long long shifted_exponent = static_cast<long long>(exponent) + power;
    const std::string text = std::string(number.substr(0, mark)) + "e" + std::to_string(shifted_exponent);
    double value = 0.0;
    std::from_chars(text.data(), text.data() + text.size(), value);
    return value;
}

double parse_quantity(std::string_view text, std::span<const Unit> units, std::string_view wanted) {
    double number = 0.0;
    const char* const end = text.data() + text.size();
    const auto result = std::from_chars(text.data(), end, number);
    if (result.ec == std::errc{} && std::isfinite(number)) {
        std::string_view rest(result.ptr, end - result.ptr);
        while (rest.starts_with(' ')) rest.remove_prefix(1);
        for (const Unit& unit : units) {
            if (unit.name != rest) continue;
            const std::string_view digits(text.data(), static_cast<std::size_t>(result.ptr - text.data()));
            return unit.power == 0 ? number * unit.factor : shifted(digits, unit.power);
        }
    }
    throw InputError("'" + std::string(text) + "' is not " + std::string(wanted));
}

}  // namespace

double parse_length(std::string_view text) {
    return parse_quantity(text, kLengths, "a length, such as 26mm, 2.6cm or 0.026 (metres)");
}

double parse_length_above_zero(const std::string& name, std::string_view text) {
    const double length = located(name, "", [&] { return parse_length(text); });
    if (length > 0.0) return length;
    throw InputError(name, "", "'" + std::string(text) + "' is not a length above zero, such as 0.5mm");
}

void refuse_missing_unit(const std::string& name, const std::string& text, double large) {
    // A length may have spaces before its unit, and so behind its number if there is no unit.
    const std::string number = text.substr(0, text.find_last_not_of(' ') + 1);
    const auto bare = read_number<double>(number);
    if (!bare || !std::isfinite(*bare) || *bare < large) return;
    throw InputError(name, "",
                     number + " without a unit is in metres; did you mean " + number +
                         "mm? Metres are written " + number + "m");
}

double parse_angle(std::string_view text) {
    return parse_quantity(text, kAngles, "an angle, such as 15, 15deg or 0.26rad");
}

double parse_number(std::string_view text) {
    return parse_quantity(text, kNone, "a finite number");
}

}  // namespace fretwork::base
