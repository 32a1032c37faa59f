// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace fretwork::exports {

/// The colour of the i-th pattern of a palette, as "#rrggbb": light, so that beams stand out. The first nine
/// can be told apart with a colour vision deficiency; further ones are far apart in hue (golden angle) and
/// differ in lightness. A negative number (not painted) is nearly white.
std::string pattern_colour(int index);

/// A perceptually even scale from dark blue (0) over green to yellow (1), after viridis; values outside are
/// clamped.
std::string scale_colour(double share);

}  // namespace fretwork::exports
