// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/outlines/detail/remarks.hpp>
#include <fretwork/outlines/svg/svg_geometry.hpp>

namespace fretwork::outlines::detail {

/// How large a drawing is, and where.
struct SvgPage {
    double width = 0.0;   ///< metres, of what the viewBox shows
    double height = 0.0;  ///< metres
    Affine to_metres{};   ///< from user units, y down, to metres, y up, with the origin at the lower left of
                          ///< the drawing
    SvgMeasure measure{};
};

/// From `width`, `height` and `viewBox` of the root. Where width and height do not say a length, the viewBox
/// counts in pixels (96 an inch), and a remark names the size.
SvgPage page_of(pugi::xml_node root, const SvgDocument& document, Remarks& remarks);

}  // namespace fretwork::outlines::detail
