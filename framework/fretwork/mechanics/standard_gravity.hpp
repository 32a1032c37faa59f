// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace fretwork::mechanics {

/// The standard acceleration of free fall, m/s2, by definition (3rd General Conference on Weights and
/// Measures, 1901). A load case file stores its acceleration as a number.
inline constexpr double kStandardGravity = 9.80665;

}  // namespace fretwork::mechanics
