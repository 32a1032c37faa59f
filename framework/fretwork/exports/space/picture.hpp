// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/exports/space/bar_scene.hpp>

#include <string>

namespace fretwork::exports {

/// A picture of the deformed bars as a PNG file: in perspective, lit by a sky and a lamp that throw soft
/// shadows, on ground that is transparent but for the shadow. Scene::picture says how large and from where;
/// without a view it is taken from the side on which tiles and displacements are seen best. Throws InputError
/// for a field that there is not, and as make_bar_scene(), and Stopped as Scene::control asks.
std::string picture_png(const Scene& scene);

}  // namespace fretwork::exports
