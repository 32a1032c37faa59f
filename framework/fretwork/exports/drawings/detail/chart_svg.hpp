// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/geometry/polygon.hpp>

#include <span>
#include <string>
#include <vector>

namespace fretwork::exports::detail {

inline constexpr const char* kInk = "#333333";
inline constexpr const char* kGrid = "#e3e6ea";

/// With four significant digits.
std::string number(double value);
/// The same with thin spaces between thousands, and without exponents of large numbers.
std::string tick_text(double value);
/// A pixel coordinate.
std::string px(double value);

struct TextStyle {
    double size = 15.0;
    const char* anchor = "middle";
    std::string more{};  ///< further attributes
};
/// `content` is put in as it is: the caller escapes what XML reserves.
std::string text(const geometry::Point2& place, const std::string& content, const TextStyle& style = {});
std::string line(const geometry::Point2& from, const geometry::Point2& to, const char* colour);

/// Lines of about `width` characters, broken behind blanks and plus signs.
std::vector<std::string> wrapped(const std::string& content, std::size_t width);

/// A logarithmic axis of a chart.
struct LogAxis {
    std::string label;
    double low = 1.0;
    double high = 10.0;

    /// Where a value lies between low (0) and high (1).
    [[nodiscard]] double share(double value) const;
    /// Round values from low to high: multiples of powers of ten, or on long axes the powers alone.
    [[nodiscard]] std::vector<double> ticks() const;
};

/// The axis that holds all values with some room at both ends. Throws InputError if there are none,
/// NumericalError if one is not above zero.
LogAxis axis_of(std::string label, std::span<const double> values);

}  // namespace fretwork::exports::detail
