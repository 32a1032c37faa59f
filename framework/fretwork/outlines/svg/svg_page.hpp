// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/outlines/detail/remarks.hpp>
#include <fretwork/outlines/svg/svg_geometry.hpp>

namespace fretwork::outlines::detail {

/// The size of a drawing, and the map to metres.
struct SvgPage {
    double width = 0.0;   ///< width of the viewBox as shown, m
    double height = 0.0;  ///< height of the viewBox as shown, m
    /// Map from user units, with y down, to metres, with y up and the origin at the lower left corner of the
    /// viewBox.
    Affine to_metres{};
    SvgMeasure measure{};  ///< size of the viewBox in user units
};

/// The page that the attributes `width`, `height` and `viewBox` of the root describe. If one of `width` and
/// `height` is not a length, it follows from the other; if neither is a length, the unit of the viewBox is
/// the pixel (96 to an inch). In both cases, a remark states the size. Without any of the three, the page has
/// 300 x 150 pixels. Throws InputError if an attribute is malformed, or if a size is not above zero.
SvgPage page_of(pugi::xml_node root, const SvgDocument& document, Remarks& remarks);

}  // namespace fretwork::outlines::detail
