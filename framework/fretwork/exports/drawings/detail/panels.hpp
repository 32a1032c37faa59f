// SPDX-License-Identifier: GPL-3.0-or-later
// Drawings that can stand alone or as panels of a figure, at true scale.
#pragma once

#include <fretwork/exports/drawings/detail/svg_canvas.hpp>
#include <fretwork/exports/drawings/surface_drawing.hpp>

namespace fretwork::exports::detail {

SvgCanvas surface_panel(const simulation::Surface& surface, const simulation::Conditions* conditions,
                        const DrawnLabels& labels);
/// The surface from above without legends. Text is `text_share` of the panel's width high.
SvgCanvas tiling_panel(const simulation::Surface& surface, const DrawnLabels& labels, double text_share);
SvgCanvas setup_panel(const simulation::Surface& surface, const simulation::Conditions& conditions,
                      const ViewOptions& view);
SvgCanvas deformed_panel(std::span<const DeformedLayer> layers, const DeformedViewOptions& options);
/// The beams of a reduced model at rest, from above; as large as the tiling_panel().
SvgCanvas reduced_panel(const simulation::Surface& surface, const LineSet& beams, double text_share);
SvgCanvas displacement_panel(const DeformedLayer& layer, const DeformedViewOptions& options);

/// "joints: stiff"
std::string joints_note(reduction::Joints joints);
/// "displacements at true scale", "displacements 5 times as large"
std::string scale_note(double scale);

}  // namespace fretwork::exports::detail
