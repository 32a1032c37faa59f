// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace fretwork::base {

/// The smallest and the largest value of a quantity in an input, in SI units. The limits lie far beyond the
/// sizes that can be built, but products of a few values within the limits neither underflow nor overflow. A
/// value outside its limits is a mistake in units or in a program. Frames, displacements in results, settings
/// and load cases are checked against these limits.
struct Limits {
    double least;           ///< smallest value of a quantity that must be above zero
    double most;            ///< largest magnitude of any value
    std::string_view unit;  ///< unit of both limits, for messages
};

/// Limits of lengths, coordinates and displacements.
inline constexpr Limits kLengthLimits{1e-12, 1e12, "m"};
/// Limits of areas of sections.
inline constexpr Limits kAreaLimits{1e-24, 1e24, "m^2"};
/// Limits of second moments of area and of torsion constants.
inline constexpr Limits kSecondMomentLimits{1e-48, 1e48, "m^4"};
/// Limits of moduli and strengths.
inline constexpr Limits kModulusLimits{1e-12, 1e18, "Pa"};
/// Limits of densities.
inline constexpr Limits kDensityLimits{1e-12, 1e12, "kg/m^3"};
/// Limits of forces.
inline constexpr Limits kForceLimits{1e-24, 1e18, "N"};
/// Limits of moments.
inline constexpr Limits kMomentLimits{1e-36, 1e30, "N m"};
/// Limits of the acceleration of gravity.
inline constexpr Limits kAccelerationLimits{1e-12, 1e12, "m/s^2"};
/// Limits of angles and rotations.
inline constexpr Limits kAngleLimits{1e-12, 1e6, "rad"};

/// True if a value that must be above zero lies within the limits. False for NaN.
constexpr bool is_positive_within(double value, const Limits& limits) {
    return value >= limits.least && value <= limits.most;
}
/// True if a value of any sign, or zero, lies within the limits. False for NaN.
constexpr bool is_within(double value, const Limits& limits) {
    return value >= -limits.most && value <= limits.most;
}

/// The valid range of a positive value for messages: "a number from 1e-12 to 1e+18 (Pa)".
std::string positive_range_text(const Limits& limits);
/// The valid range of a value of any sign for messages: "a number from -1e+18 to 1e+18 (N)".
std::string range_text(const Limits& limits);

}  // namespace fretwork::base
