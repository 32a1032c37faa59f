// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/exports/space/detail/bar_mesh.hpp>

#include <string>

namespace fretwork::exports::detail {

/// The name that stands for no field; bars then have one colour.
inline constexpr const char* kPlainColour = "plain";

/// The linear light, 0 to 1, of an sRGB value, 0 to 1.
float linear_light(double screen);

/// The light of a colour "#rrggbb".
Eigen::Vector3f linear_colour(const std::string& text);

/// The colours of a field, or of plain bars if the name is "plain" or the scene has no fields. Throws
/// InputError for an unknown field, and for a field without any known value.
EndColours end_colours(const BarScene& scene, const std::string& name);

}  // namespace fretwork::exports::detail
