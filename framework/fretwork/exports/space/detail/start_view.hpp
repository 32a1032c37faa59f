// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/exports/space/bar_scene.hpp>

namespace fretwork::exports::detail {

/// From where a scene is seen first: as it says, or else from the side on which tiles and displacements are
/// seen best.
ViewOptions start_view(const BarScene& bars, const Scene& scene);

}  // namespace fretwork::exports::detail
