// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/outlines/regions/filled_region.hpp>

namespace fretwork::outlines::detail {

/// True if a shape fills the point; clips are ignored.
bool is_filled_at(const FilledShape& shape, geometry::Point2 point);

/// True if a point lies in a clip of a picture and in all its outer clips. Without a clip, the result is
/// true.
bool is_shown_at(const Picture& picture, std::optional<std::size_t> clip, geometry::Point2 point);

/// True if a whole line lies in one shape of a clip, and likewise in all outer clips. Without a clip, the
/// result is true. Points within `margin` (m) of a shape's edge count as inside. If a line lies partly in one
/// shape and partly in another, the result is false.
bool is_shown_whole(const Picture& picture, std::optional<std::size_t> clip, const geometry::Polygon& line,
                    double margin);

}  // namespace fretwork::outlines::detail
