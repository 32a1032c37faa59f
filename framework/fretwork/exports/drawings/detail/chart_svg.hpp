// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/geometry/polygon.hpp>

#include <span>
#include <string>
#include <vector>

namespace fretwork::exports::detail {

inline constexpr const char* kInk = "#333333";
inline constexpr const char* kGrid = "#e3e6ea";

/// A number with four significant digits.
std::string number(double value);
/// The text of number(); from 10,000 on, without exponent and with thin spaces between thousands.
std::string tick_text(double value);
/// A pixel coordinate.
std::string px(double value);

struct TextStyle {
    double size = 15.0;
    const char* anchor = "middle";
    std::string more{};  ///< further attributes
};
/// A text element. The caller escapes the characters of `content` that XML reserves.
std::string text(const geometry::Point2& place, const std::string& content, const TextStyle& style = {});
std::string line(const geometry::Point2& from, const geometry::Point2& to, const char* colour);

/// Lines of about `width` characters, broken behind blanks and plus signs.
std::vector<std::string> wrapped(const std::string& content, std::size_t width);

/// A logarithmic axis of a chart.
struct LogAxis {
    std::string label;
    double low = 1.0;
    double high = 10.0;

    /// The place of a value on the axis, from 0 (low) to 1 (high).
    [[nodiscard]] double share(double value) const;
    /// Round values from low to high: multiples of powers of ten, or on long axes the powers alone.
    [[nodiscard]] std::vector<double> ticks() const;
};

/// The axis that holds all values with some room at both ends. Throws InputError if there are no values, and
/// NumericalError if a value is not above zero or not finite.
LogAxis axis_of(std::string label, std::span<const double> values);

}  // namespace fretwork::exports::detail
