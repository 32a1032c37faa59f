// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/text.hpp>
#include <fretwork/exports/drawings/detail/chart_svg.hpp>

#include <cstdio>

namespace fretwork::exports::detail {
namespace {

std::string print(const char* format, double value) {
    char buffer[40];
    std::snprintf(buffer, sizeof buffer, format, value);
    return buffer;
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

}  // namespace fretwork::exports::detail
