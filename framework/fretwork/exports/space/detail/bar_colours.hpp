// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/exports/space/detail/bar_mesh.hpp>

#include <string>

namespace fretwork::exports::detail {

/// The name of no field: bars have one colour.
inline constexpr const char* kPlainColour = "plain";

/// Light from 0 to 1 of a screen's value from 0 to 1.
float linear_light(double screen);

/// The light of a colour "#rrggbb".
Eigen::Vector3f linear_colour(const std::string& text);

/// The colours of a field, or of plain bars if the name is "plain" or the scene has no fields. Throws
/// InputError for an unknown field, and for one that the result's model does not know.
EndColours end_colours(const BarScene& scene, const std::string& name);

}  // namespace fretwork::exports::detail
