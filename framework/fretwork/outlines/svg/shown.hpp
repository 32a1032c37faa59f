// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/outlines/regions/filled_region.hpp>

namespace fretwork::outlines::detail {

/// Whether a point lies in what a shape fills, clips aside.
bool is_filled_at(const FilledShape& shape, geometry::Point2 point);

/// Whether a point lies in a clip of a picture, and in those around it.
bool is_shown_at(const Picture& picture, std::optional<std::size_t> clip, geometry::Point2 point);

/// Whether all of a line lies in a clip; on its edge, give or take `margin` (metres), is in it. No for a line
/// across an edge between two shapes of a clip, too.
bool is_shown_whole(const Picture& picture, std::optional<std::size_t> clip, const geometry::Polygon& line,
                    double margin);

}  // namespace fretwork::outlines::detail
