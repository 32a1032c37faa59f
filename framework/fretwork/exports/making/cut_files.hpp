// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/fabrication/cut_sheet.hpp>

#include <string>

namespace fretwork::exports {

/// A sheet for a laser, a mill or a plotter, in millimetres at true scale, with the layers `cut`, `engrave`,
/// `labels` and `guides`.
///
/// DXF (R2000): each contour a closed LWPOLYLINE with bulges in model space; $INSUNITS says millimetres.
std::string cut_dxf(const fabrication::CutSheet& sheet);
/// SVG: each piece a path with true arcs; layers as Inkscape's. y points up as in the DXF.
std::string cut_svg(const fabrication::CutSheet& sheet);

}  // namespace fretwork::exports
