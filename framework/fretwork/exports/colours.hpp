// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace fretwork::exports {

/// The colour of tiles with a pattern of this index, from 0, as "#rrggbb". All colours are light, so that
/// beams stand out. The first nine are distinct for people with a colour vision deficiency. Further colours
/// are far apart in hue (golden angle) and differ in lightness. A negative index (not painted) is nearly
/// white.
std::string pattern_colour(int index);

/// The colour of a value on a perceptually even scale, after viridis: dark purple (0), blue, green,
/// yellow (1). Values outside [0, 1] are clamped.
std::string scale_colour(double share);

/// The colour of a value on a scale for both signs, after ColorBrewer's RdBu: dark blue (0), nearly white
/// (0.5), dark red (1). Values outside [0, 1] are clamped.
std::string signed_colour(double share);

/// Red, green and blue of a colour "#rrggbb", 0 to 255.
std::array<std::uint8_t, 3> colour_bytes(const std::string& colour);

/// The colours of scale_colour() at nine equally spaced values from 0 to 1, as "#rrggbb". The scale is linear
/// between two neighbouring colours, so other programs can reproduce it.
std::vector<std::string> scale_samples();
/// The colours of signed_colour() at the same values, as "#rrggbb".
std::vector<std::string> signed_samples();

/// The range of a colour scale.
struct ValueRange {
    double from = 0.0;  ///< value of the first colour
    double to = 0.0;    ///< value of the last colour
};
/// The range from the lowest to the highest value, or from 0 to 0 without values. NaN is ignored.
ValueRange whole_range(std::span<const double> values);
/// A range that starts at zero or, if a value is negative, is symmetric about zero. A few values far above
/// all others in size are ignored, because otherwise only these would be visible. Without values, the range
/// is from 0 to 0. NaN is ignored.
ValueRange value_range(std::span<const double> values);
/// The colour of values beyond the range. It is in neither scale, so overloaded beams stand out.
inline constexpr const char* kBeyondColour = "#f018b4";
/// The largest absolute value beyond a range; nothing if no value is beyond it.
std::optional<double> largest_beyond(std::span<const double> values, const ValueRange& range);
/// The colour of a value by scale_colour(), or by signed_colour() if the range has negative values. Values
/// beyond the range have kBeyondColour; NaN is grey.
std::string value_colour(double value, const ValueRange& range);

}  // namespace fretwork::exports
