// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/outlines/svg/svg_text.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <iterator>
#include <numbers>
#include <optional>

namespace fretwork::outlines::detail {
namespace {

using geometry::Point2;

constexpr double kDegree = std::numbers::pi / 180;

bool is_separator(char c) {
    return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f' || c == ',';
}

bool is_letter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

/// The factor that turns a length into pixels, or an angle into degrees. Only transforms in style sheets
/// have units.
double factor_of_unit(std::string_view unit, const SvgText& text) {
    if (unit.empty() || unit == "px" || unit == "deg") return 1;
    if (unit == "rad") return 1 / kDegree;
    if (unit == "grad") return 0.9;
    if (unit == "turn") return 360;
    if (unit == "mm") return 96 / 25.4;
    text.fail("the unit '" + std::string(unit) + "' is none of px, mm, deg, rad, grad, turn");
}

/// The arguments of one function of a transform, up to the closing bracket.
std::vector<double> arguments(SvgText& text) {
    std::vector<double> values;
    text.expect('(');
    while (text.at_number()) {
        values.push_back(text.number());
        values.back() *= factor_of_unit(text.word(), text);
    }
    text.expect(')');
    return values;
}

using Numbers = std::vector<double>;

Affine rotation(const Numbers& v) {
    const double angle = v[0] * kDegree;
    return {std::cos(angle), std::sin(angle), -std::sin(angle), std::cos(angle), 0, 0};
}

Affine shift(double x, double y) {
    return {1, 0, 0, 1, x, y};
}

/// A function of a transform, with its number of arguments.
struct TransformFunction {
    std::string_view name;
    std::size_t count;
    Affine (*map)(const Numbers& v);
};

constexpr TransformFunction kFunctions[] = {
    {"matrix", 6, [](const Numbers& v) { return Affine{v[0], v[1], v[2], v[3], v[4], v[5]}; }},
    {"translate", 1, [](const Numbers& v) { return shift(v[0], 0); }},
    {"translate", 2, [](const Numbers& v) { return shift(v[0], v[1]); }},
    {"translateX", 1, [](const Numbers& v) { return shift(v[0], 0); }},
    {"translateY", 1, [](const Numbers& v) { return shift(0, v[0]); }},
    {"scale", 1, [](const Numbers& v) { return Affine{v[0], 0, 0, v[0], 0, 0}; }},
    {"scale", 2, [](const Numbers& v) { return Affine{v[0], 0, 0, v[1], 0, 0}; }},
    {"scaleX", 1, [](const Numbers& v) { return Affine{v[0], 0, 0, 1, 0, 0}; }},
    {"scaleY", 1, [](const Numbers& v) { return Affine{1, 0, 0, v[0], 0, 0}; }},
    {"rotate", 1, rotation},
    {"rotate", 3,
     [](const Numbers& v) { return shift(v[1], v[2]).after(rotation(v)).after(shift(-v[1], -v[2])); }},
    {"skew", 1, [](const Numbers& v) { return Affine{1, 0, std::tan(v[0] * kDegree), 1, 0, 0}; }},
    {"skewX", 1, [](const Numbers& v) { return Affine{1, 0, std::tan(v[0] * kDegree), 1, 0, 0}; }},
    {"skewY", 1, [](const Numbers& v) { return Affine{1, std::tan(v[0] * kDegree), 0, 1, 0, 0}; }},
};

/// The map of a function; nothing if no function with this name takes this number of arguments.
std::optional<Affine> function_map(std::string_view name, const Numbers& v) {
    const auto* const found = std::ranges::find_if(kFunctions, [&](const TransformFunction& function) {
        return function.name == name && function.count == v.size();
    });
    if (found == std::end(kFunctions)) return std::nullopt;
    return found->map(v);
}

}  // namespace

void SvgText::skip_separators() {
    while (next_ < text_.size() && is_separator(text_[next_])) ++next_;
}

bool SvgText::at_end() {
    skip_separators();
    return next_ == text_.size();
}

bool SvgText::at_number() {
    return !at_end() && std::string_view("+-.0123456789").find(text_[next_]) != std::string_view::npos;
}

double SvgText::number() {
    if (!at_number()) fail("a number is expected");
    const char* first = text_.data() + next_ + (text_[next_] == '+' ? 1 : 0);
    double value = 0;
    const auto [end, error] = std::from_chars(first, text_.data() + text_.size(), value);
    if (error != std::errc() || !std::isfinite(value)) fail("a number is expected");
    next_ = end - text_.data();
    return value;
}

bool SvgText::flag() {
    if (at_end() || (text_[next_] != '0' && text_[next_] != '1')) fail("a flag, 0 or 1, is expected");
    return text_[next_++] == '1';
}

char SvgText::letter() {
    if (at_end() || !is_letter(text_[next_])) fail("a letter is expected");
    return text_[next_++];
}

std::string_view SvgText::word() {
    const std::size_t first = next_;
    while (next_ < text_.size() && (is_letter(text_[next_]) || text_[next_] == '%')) ++next_;
    return text_.substr(first, next_ - first);
}

void SvgText::expect(char wanted) {
    if (at_end() || text_[next_] != wanted) fail(std::string("'") + wanted + "' is expected");
    ++next_;
}

void SvgText::fail(const std::string& message) const {
    constexpr std::size_t kMost = 24;
    const std::string found =
        next_ < text_.size() ? "'" + std::string(text_.substr(next_, kMost)) + "'" : "the end";
    throw base::InputError(message + ": character " + std::to_string(next_ + 1) + ", at " + found);
}

std::vector<Point2> parse_svg_points(std::string_view text) {
    SvgText walk(text);
    std::vector<Point2> points;
    while (!walk.at_end()) {
        const double x = walk.number();
        points.push_back({x, walk.number()});
    }
    return points;
}

Affine parse_svg_transform(std::string_view text) {
    SvgText walk(text);
    Affine map;
    if (text == "none") return map;
    while (!walk.at_end()) {
        std::string name(1, walk.letter());
        name += walk.word();
        const std::vector<double> values = arguments(walk);
        const auto function = function_map(name, values);
        if (!function)
            walk.fail("'" + name + "' with " + std::to_string(values.size()) +
                      " numbers is not a transformation");
        map = map.after(*function);
    }
    return map;
}

SvgLength parse_svg_length(std::string_view text) {
    struct Unit {
        std::string_view name;
        double factor;
        SvgLength::Unit unit = SvgLength::Unit::Pixel;
    };
    constexpr double kInch = 96;
    constexpr std::array<Unit, 12> kUnits = {{{"", 1},
                                              {"px", 1},
                                              {"mm", kInch / 25.4},
                                              {"cm", kInch / 2.54},
                                              {"in", kInch},
                                              {"pt", kInch / 72},
                                              {"pc", kInch / 6},
                                              {"Q", kInch / 101.6},
                                              {"%", 0.01, SvgLength::Unit::Percent},
                                              {"em", 1, SvgLength::Unit::Em},
                                              {"ex", 0.5, SvgLength::Unit::Em},
                                              {"rem", 1, SvgLength::Unit::Rem}}};
    SvgText walk(text);
    const double value = walk.number();
    const std::string_view name = walk.word();
    if (!walk.at_end()) walk.fail("nothing more is expected");
    for (const Unit& unit : kUnits) {
        if (unit.name == name) return {value * unit.factor, unit.unit};
    }
    walk.fail("the unit '" + std::string(name) + "' is none of px, mm, cm, in, pt, pc, Q, %, em, ex, rem");
}

}  // namespace fretwork::outlines::detail
