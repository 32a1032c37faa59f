// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/exports/space/bar_scene.hpp>

#include <string>

namespace fretwork::exports {

/// A picture of the deformed bars as a PNG file: in perspective, lit by a sky and a lamp that throw soft
/// shadows, on ground that is transparent except for the shadow. Scene::picture gives size and camera;
/// without a camera the picture is taken from the side that shows tiles and displacements best. Throws
/// InputError for an unknown field, and as make_bar_scene(), and Stopped as Scene::control asks.
std::string picture_png(const Scene& scene);

/// One HTML file that shows the bars in 3D in any browser with WebGL 2, and needs nothing besides: to turn,
/// to zoom, deformed or at rest, with a colour map. The page is view.html, which is part of the library.
/// Throws as make_bar_scene().
std::string view_html(const Scene& scene);

}  // namespace fretwork::exports
