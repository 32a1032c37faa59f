// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/exports/space/bar_scene.hpp>

#include <string>

namespace fretwork::exports {

/// A picture of the deformed bars as a PNG file, in perspective. A sky and a lamp cast soft shadows on a
/// transparent ground. Scene::picture gives the size and the colours, and Scene::view the direction of the
/// camera. Without Scene::view, the direction that shows tiles and displacements best is chosen. Without a
/// result, bars are plain. Throws InputError for a field of a result that is unknown or without values, and
/// if no tile is painted; also as make_bar_scene(). Throws IoError if libpng refuses the size. Throws Stopped
/// if Scene::control asks to stop.
std::string picture_png(const Scene& scene);

/// A binary glTF 2.0 file (.glb) with the bars at rest as triangles, a morph target for each load step of the
/// first result, and an animation from rest through the load steps. A result without load steps has one
/// target, its own state; without a result, nothing moves. Lengths are in metres. The file's node is turned
/// so that z points up. Scene::picture selects the colours; they show the result. Throws InputError as
/// picture_png(), and if the file would exceed 4 GiB. Throws Stopped if Scene::control asks to stop.
std::string motion_glb(const Scene& scene);

/// A self-contained HTML page that shows the bars in 3D in any browser with WebGL 2. The user can turn and
/// zoom the view, switch between the deformed state and rest, and choose the field that the colours show. The
/// template view.html is built into the library. Throws as make_bar_scene().
std::string view_html(const Scene& scene);

}  // namespace fretwork::exports
