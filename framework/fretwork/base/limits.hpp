// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace fretwork::base {

/// How small and how large the values of a quantity may be in an input, SI units. The limits are far beyond
/// what can be built, and so near that no product of a few values vanishes or overflows: a value outside is a
/// slip of units or of a program. All readers and checks of inputs use those listed here.
struct Limits {
    double least;  ///< of a value that must be above zero
    double most;   ///< of any value's magnitude
    std::string_view unit;
};

inline constexpr Limits kLengthLimits{1e-12, 1e12, "m"};  ///< and coordinates, and displacements
inline constexpr Limits kAreaLimits{1e-24, 1e24, "m^2"};
inline constexpr Limits kSecondMomentLimits{1e-48, 1e48, "m^4"};
inline constexpr Limits kModulusLimits{1e-12, 1e18, "Pa"};
inline constexpr Limits kDensityLimits{1e-12, 1e12, "kg/m^3"};
inline constexpr Limits kForceLimits{1e-24, 1e18, "N"};
inline constexpr Limits kMomentLimits{1e-36, 1e30, "N m"};
inline constexpr Limits kAccelerationLimits{1e-12, 1e12, "m/s^2"};
inline constexpr Limits kAngleLimits{1e-12, 1e6, "rad"};

/// Whether a value that must be above zero lies within the limits. False for NaN.
constexpr bool is_positive_within(double value, const Limits& limits) {
    return value >= limits.least && value <= limits.most;
}
/// Whether a value of any sign, or zero, does.
constexpr bool is_within(double value, const Limits& limits) {
    return value >= -limits.most && value <= limits.most;
}

/// "a number from 1e-12 to 1e+18 (Pa)", for messages.
std::string positive_range_text(const Limits& limits);
/// "a number from -1e+18 to 1e+18 (N)"
std::string range_text(const Limits& limits);

}  // namespace fretwork::base
