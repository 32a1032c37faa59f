// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/exports/colours.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <vector>

namespace fretwork::exports {
namespace {

using Rgb = std::array<double, 3>;  // each 0 to 1

std::string hex(const Rgb& rgb) {
    char buffer[8];
    const auto byte = [](double share) {
        return static_cast<unsigned>(std::lround(255.0 * std::clamp(share, 0.0, 1.0))) & 0xffU;
    };
    std::snprintf(buffer, sizeof buffer, "#%02x%02x%02x", byte(rgb[0]), byte(rgb[1]), byte(rgb[2]));
    return buffer;
}

/// OKLCH (Ottosson 2020): lightness and chroma as the eye sees them; hue in turns. The result may be out of
/// the screen's range; hex() clamps it.
Rgb from_oklch(double lightness, double chroma, double hue) {
    constexpr double kTwoPi = 6.283185307179586;
    const double a = chroma * std::cos(kTwoPi * hue);
    const double b = chroma * std::sin(kTwoPi * hue);
    const auto cube = [](double x) { return x * x * x; };
    const double l = cube(lightness + 0.3963377774 * a + 0.2158037573 * b);
    const double m = cube(lightness - 0.1055613458 * a - 0.0638541728 * b);
    const double s = cube(lightness - 0.0894841775 * a - 1.2914855480 * b);
    const auto gamma = [](double x) {
        return x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1.0 / 2.4) - 0.055;
    };
    return {gamma(4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s),
            gamma(-1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s),
            gamma(-0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s)};
}

using Samples = std::array<Rgb, 9>;  // of a scale, at equal distances; the scale is linear between them

// The viridis map (CC0).
constexpr Samples kScale = {{{0.267, 0.005, 0.329},
                             {0.279, 0.175, 0.483},
                             {0.230, 0.322, 0.546},
                             {0.173, 0.449, 0.558},
                             {0.128, 0.567, 0.551},
                             {0.158, 0.684, 0.502},
                             {0.369, 0.789, 0.383},
                             {0.678, 0.864, 0.190},
                             {0.993, 0.906, 0.144}}};
constexpr Samples kSigned = {{{0.020, 0.188, 0.380},
                              {0.129, 0.400, 0.674},
                              {0.263, 0.576, 0.765},
                              {0.573, 0.773, 0.871},
                              {0.941, 0.941, 0.941},
                              {0.957, 0.647, 0.510},
                              {0.839, 0.376, 0.302},
                              {0.698, 0.094, 0.169},
                              {0.404, 0.000, 0.122}}};

std::string mixed(const Samples& samples, double share) {
    const double place = std::clamp(share, 0.0, 1.0) * static_cast<double>(samples.size() - 1);
    const auto below = std::min(static_cast<std::size_t>(place), samples.size() - 2);
    const double rest = place - static_cast<double>(below);
    Rgb colour{};
    for (std::size_t c = 0; c < 3; ++c)
        colour[c] = (1.0 - rest) * samples[below][c] + rest * samples[below + 1][c];
    return hex(colour);
}

std::vector<std::string> texts(const Samples& samples) {
    std::vector<std::string> colours;
    for (const Rgb& colour : samples) colours.push_back(hex(colour));
    return colours;
}

bool is_beyond(double value, const ValueRange& range) {
    const double rounding = 1e-4 * (range.to - range.from);
    return value > range.to + rounding || value < range.from - rounding;
}

}  // namespace

std::string pattern_colour(int index) {
    // The first nine are the "light" scheme of Paul Tol (2021), made for filled areas and for colour-blind
    // readers.
    constexpr std::array<const char*, 9> kFirst = {"#77aadd", "#eedd88", "#44bb99", "#ffaabb", "#bbcc33",
                                                   "#ee8866", "#99ddff", "#aaaa00", "#dddddd"};
    if (index < 0) return "#f4f6f8";
    const std::size_t place = index;
    if (place < kFirst.size()) return kFirst[place];
    constexpr double kGoldenTurn = 0.3819660112501051;
    constexpr std::array<double, 3> kLightness = {0.87, 0.78, 0.70};
    const double turns = kGoldenTurn * index;
    return hex(from_oklch(kLightness[place % kLightness.size()], 0.085, turns - std::floor(turns)));
}

std::string scale_colour(double share) {
    return mixed(kScale, share);
}

std::string signed_colour(double share) {
    return mixed(kSigned, share);
}

std::array<std::uint8_t, 3> colour_bytes(const std::string& colour) {
    const auto byte = [&](std::size_t at) {
        return static_cast<std::uint8_t>(std::stoi(colour.substr(at, 2), nullptr, 16));
    };
    return {byte(1), byte(3), byte(5)};
}

std::vector<std::string> scale_samples() {
    return texts(kScale);
}

std::vector<std::string> signed_samples() {
    return texts(kSigned);
}

ValueRange whole_range(std::span<const double> values) {
    ValueRange range{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
    for (const double value : values) {
        if (std::isnan(value)) continue;
        range = {std::min(range.from, value), std::max(range.to, value)};
    }
    return range.from <= range.to ? range : ValueRange{};
}

ValueRange value_range(std::span<const double> values) {
    std::vector<double> sizes;
    for (const double value : values) {
        if (!std::isnan(value)) sizes.push_back(std::abs(value));
    }
    if (sizes.empty()) return {};
    std::ranges::sort(sizes);
    constexpr double kFar = 1.5;
    const double usual = sizes[(sizes.size() - 1) * 99 / 100];
    const double to = usual > 0.0 && sizes.back() > kFar * usual ? usual : sizes.back();
    constexpr double kRounding = 1e-9;
    const bool is_signed = whole_range(values).from < -kRounding * to;
    return {is_signed ? -to : 0.0, to};
}

std::optional<double> largest_beyond(std::span<const double> values, const ValueRange& range) {
    std::optional<double> largest;
    for (const double value : values)
        if (is_beyond(value, range)) largest = std::max(largest.value_or(0.0), std::abs(value));
    return largest;
}

std::string value_colour(double value, const ValueRange& range) {
    if (std::isnan(value)) return "#999999";
    if (is_beyond(value, range)) return kBeyondColour;
    const double share = range.to > range.from ? (value - range.from) / (range.to - range.from) : 0.0;
    return range.from < 0.0 ? signed_colour(share) : scale_colour(share);
}

}  // namespace fretwork::exports
