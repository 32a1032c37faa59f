// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/exports/drawings/detail/chart_svg.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace fretwork::exports::detail {
namespace {

std::string print(const char* format, double value) {
    char buffer[40];
    std::snprintf(buffer, sizeof buffer, format, value);
    return buffer;
}

/// The multiples of powers of ten that an axis of this length marks.
std::vector<double> factors_of(double decades) {
    if (decades > 2.2) return {1.0};
    if (decades > 1.0) return {1.0, 2.0, 5.0};
    return {1.0, 1.5, 2.0, 3.0, 4.0, 6.0, 8.0};
}

}  // namespace

std::string number(double value) {
    return base::format_number(value, 4);
}

std::string tick_text(double value) {
    if (value < 1e4) return number(value);
    std::string digits = print("%.0f", value);
    for (auto at = std::ssize(digits) - 3; at > 0; at -= 3) digits.insert(at, "\u2009");
    return digits;
}

std::string px(double value) {
    return print("%.2f", value);
}

std::string text(const geometry::Point2& place, const std::string& content, const TextStyle& style) {
    return "<text x=\"" + px(place.x) + "\" y=\"" + px(place.y) + "\" font-size=\"" + px(style.size) +
           "\" text-anchor=\"" + style.anchor + "\"" + style.more + ">" + content + "</text>\n";
}

std::string line(const geometry::Point2& from, const geometry::Point2& to, const char* colour) {
    return "<line x1=\"" + px(from.x) + "\" y1=\"" + px(from.y) + "\" x2=\"" + px(to.x) + "\" y2=\"" +
           px(to.y) + "\" stroke=\"" + colour + "\"/>\n";
}

std::vector<std::string> wrapped(const std::string& content, std::size_t width) {
    std::vector<std::string> rows(1);
    std::string word;
    for (const char c : content + " ") {
        word += c;
        if (c != ' ' && c != '+') continue;
        if (!rows.back().empty() && rows.back().size() + word.size() > width + 1) rows.emplace_back();
        rows.back() += word;
        word.clear();
    }
    return rows;
}

double LogAxis::share(double value) const {
    return std::log(value / low) / std::log(high / low);
}

std::vector<double> LogAxis::ticks() const {
    const double decades = std::log10(high / low);
    std::vector<double> ticks;
    for (double power = std::pow(10.0, std::floor(std::log10(low))); power <= high; power *= 10.0) {
        for (const double factor : factors_of(decades)) {
            const double value = factor * power;
            if (value >= low && value <= high) ticks.push_back(value);
        }
    }
    return ticks;
}

LogAxis axis_of(std::string label, std::span<const double> values) {
    if (values.empty()) throw base::InputError("there is nothing to chart");
    const auto [least, most] = std::ranges::minmax(values);
    if (!(least > 0.0) || !std::isfinite(most)) {
        throw base::NumericalError(label + ": " + base::format_number(least > 0.0 ? most : least) +
                                   " has no place on a logarithmic axis");
    }
    const double room = std::max(1.12, std::pow(most / least, 0.05));
    return {std::move(label), least / room, most * room};
}

}  // namespace fretwork::exports::detail
