// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/exports/space/bar_scene.hpp>

#include <string>

namespace fretwork::exports {

/// One HTML file that shows the bars in 3D in any browser with WebGL 2, and needs nothing besides: to turn,
/// to zoom, deformed or at rest, with a colour map. The page is view.html, which is part of the library.
/// Throws as make_bar_scene().
std::string view_html(const Scene& scene);

}  // namespace fretwork::exports
