// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace fretwork::exports {

/// The colour of the i-th pattern of a palette, as "#rrggbb". Colours are light, so that beams stand out. The
/// first nine are distinct under a colour vision deficiency. Further ones are far apart in hue (golden angle)
/// and differ in lightness. The colour of a negative index (not painted) is nearly white.
std::string pattern_colour(int index);

/// The colour of a value on a perceptually even scale, after viridis: dark blue (0), green, yellow (1).
/// Values outside are clamped.
std::string scale_colour(double share);

/// The colour of a value on a scale for both signs, after ColorBrewer's RdBu: dark blue (0), nearly white
/// (0.5), dark red (1). Values outside are clamped.
std::string signed_colour(double share);

/// The colours of a scale at equally spaced values, as "#rrggbb". The scale is linear between them, so a page
/// can draw with it.
std::vector<std::string> scale_samples();
/// Colours from blue over white to red, for values of both signs.
std::vector<std::string> signed_samples();

/// The range of a colour scale.
struct ValueRange {
    double from = 0.0;  ///< the first colour's value
    double to = 0.0;    ///< the last colour's value
};
/// The range from the lowest to the highest value. NaN is ignored.
ValueRange whole_range(std::span<const double> values);
/// A range that starts at zero or, if values have both signs, is symmetric about zero. A few values far above
/// all others are left out, because otherwise only they would be visible.
ValueRange value_range(std::span<const double> values);
/// The colour of values beyond the range. It is in neither scale, so that overloaded bars stand out.
inline constexpr const char* kBeyondColour = "#f018b4";
/// The largest absolute value beyond a range; nothing if no value is beyond it.
std::optional<double> largest_beyond(std::span<const double> values, const ValueRange& range);
/// The colour of a value by scale_colour(), or by signed_colour() if the range has negative values. Grey for
/// NaN.
std::string value_colour(double value, const ValueRange& range);

}  // namespace fretwork::exports
