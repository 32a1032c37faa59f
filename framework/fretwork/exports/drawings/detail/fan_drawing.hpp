// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/exports/drawings/detail/svg_canvas.hpp>
#include <fretwork/exports/drawings/pattern_drawing.hpp>

namespace fretwork::exports::detail {

/// The place of a fan, and the colour below it.
struct FanPlace {
    geometry::Point2 center;  ///< metres
    Colour face;              ///< of its polygon
};

/// The colour of interface nodes.
inline constexpr const char* kInterfaceColour = "#1b9e77";

/// Draw the beams of a pattern's fan on a polygon.
void draw_fan_beams(SvgCanvas& canvas, const pattern::NodeLayout& layout, const pattern::Pattern& pattern,
                    const geometry::Polygon& polygon, const Style& style);

/// Draw a pattern's fan with beams of true width on its regular polygon. The beams of `guilty`, which are
/// some of the pattern's, are red.
void draw_fan(SvgCanvas& canvas, const pattern::NodeLayout& layout, const pattern::Pattern& pattern,
              const FanPlace& place, const PatternDrawingOptions& options,
              const pattern::Pattern& guilty = {});

}  // namespace fretwork::exports::detail
