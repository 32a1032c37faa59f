// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace fretwork::exports {

/// The colour of the i-th pattern of a palette, as "#rrggbb": light, so that beams stand out. The first nine
/// are distinct under a colour vision deficiency; further ones are far apart in hue (golden angle) and differ
/// in lightness. A negative number (not painted) is nearly white.
std::string pattern_colour(int index);

/// A perceptually even scale from dark blue (0) over green to yellow (1), after viridis; values outside are
/// clamped.
std::string scale_colour(double share);

/// From dark blue (0) over nearly white (0.5) to dark red (1), after ColorBrewer's RdBu; values outside are
/// clamped.
std::string signed_colour(double share);

/// The colours of a scale at equal distances, between which it goes straight, as "#rrggbb": for pages, which
/// draw by themselves.
std::vector<std::string> scale_samples();
std::vector<std::string> signed_samples();

/// The range of a colour scale.
struct ValueRange {
    double from = 0.0;
    double to = 0.0;
};
/// From the lowest value to the highest; NaN is passed over.
ValueRange whole_range(std::span<const double> values);
/// From zero, or evenly around zero where values have both signs. A few values that are far above all others
/// are left out, or they alone would be seen.
ValueRange value_range(std::span<const double> values);
/// Out-of-range colour, in neither scale, so that overloaded bars stand out.
inline constexpr const char* kBeyondColour = "#f018b4";
/// The largest size of the values beyond a range; nothing if none is there.
std::optional<double> largest_beyond(std::span<const double> values, const ValueRange& range);
/// scale_colour(), or signed_colour() where the range goes below zero. Grey for NaN.
std::string value_colour(double value, const ValueRange& range);

}  // namespace fretwork::exports
