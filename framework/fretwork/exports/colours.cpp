// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/exports/colours.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

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

/// Hue in turns, saturation and lightness from 0 to 1.
Rgb from_hsl(double hue, double saturation, double lightness) {
    const double chroma = saturation * std::min(lightness, 1.0 - lightness);
    const auto channel = [&](double offset) {
        const double k = std::fmod(offset + 12.0 * hue, 12.0);
        return lightness - chroma * std::max(-1.0, std::min({k - 3.0, 9.0 - k, 1.0}));
    };
    return {channel(0.0), channel(8.0), channel(4.0)};
}

}  // namespace

std::string pattern_colour(int index) {
    constexpr double kGoldenTurn = 0.3819660112501051;
    constexpr std::array<double, 3> kLightness = {0.74, 0.84, 0.64};
    const double turns = 0.08 + kGoldenTurn * index;
    return hex(from_hsl(turns - std::floor(turns), 0.55, kLightness[static_cast<std::size_t>(index % 3)]));
}

std::string scale_colour(double share) {
    // Nine samples of the viridis map (CC0), between which we go straight.
    constexpr std::array<Rgb, 9> kSamples = {{{0.267, 0.005, 0.329},
                                              {0.279, 0.175, 0.483},
                                              {0.230, 0.322, 0.546},
                                              {0.173, 0.449, 0.558},
                                              {0.128, 0.567, 0.551},
                                              {0.158, 0.684, 0.502},
                                              {0.369, 0.789, 0.383},
                                              {0.678, 0.864, 0.190},
                                              {0.993, 0.906, 0.144}}};
    const double place = std::clamp(share, 0.0, 1.0) * (kSamples.size() - 1);
    const auto below = std::min<std::size_t>(static_cast<std::size_t>(place), kSamples.size() - 2);
    const double rest = place - static_cast<double>(below);
    Rgb mixed{};
    for (std::size_t c = 0; c < 3; ++c)
        mixed[c] = (1.0 - rest) * kSamples[below][c] + rest * kSamples[below + 1][c];
    return hex(mixed);
}

}  // namespace fretwork::exports
