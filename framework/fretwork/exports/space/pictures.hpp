// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/exports/space/bar_scene.hpp>

#include <string>

namespace fretwork::exports {

/// A picture of the deformed bars as a PNG file, in perspective. A sky and a lamp cast soft shadows on a
/// ground that is otherwise transparent. Scene::picture gives the size and the colours, Scene::view the
/// camera; without a view, the camera shows tiles and displacements best. Throws InputError for an unknown
/// field, and as make_bar_scene(); Stopped if Scene::control asks to stop.
std::string picture_png(const Scene& scene);

/// One self-contained HTML file that shows the bars in 3D in any browser with WebGL 2. Its user can turn,
/// zoom, switch between deformed and at rest, and choose a colour map. The page is made from view.html, which
/// is built into the library. Throws as make_bar_scene().
std::string view_html(const Scene& scene);

}  // namespace fretwork::exports
