// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/exports/tables/line_set.hpp>
#include <fretwork/simulation/load_cases/conditions.hpp>
#include <fretwork/simulation/surface.hpp>

#include <span>
#include <string>

namespace fretwork::exports {

/// The direction of the viewer in a parallel projection.
struct ViewOptions {
    double azimuth = -0.6;   ///< angle about z, rad; at 0, x points to the right
    double elevation = 0.6;  ///< angle above the plane, rad
};

/// The numbers shown on a drawing.
struct DrawnLabels {
    /// Whether numbers are drawn.
    enum class Shown { No, Yes };
    Shown tiles = Shown::No;            ///< numbers of tiles
    Shown interface_nodes = Shown::No;  ///< numbers of interface nodes
};

/// A surface seen from above at true scale, as in the paper's Figs. 12 to 14: tiles coloured by pattern,
/// beams as wide as a square with the area of their section, a legend and a scale bar. Tiles without a
/// pattern are empty. If `conditions` is not null, the drawing also shows supports, prescribed displacements
/// (diamonds) and the loads of each node with its share of the weight. Supports are red (all dofs are held),
/// green (only translations) or orange (other dofs). Loads are arrows, or rings if they point out of the
/// plane; moments have two heads. Text is legible when the drawing is scaled to a journal's column. Only
/// numbers may be smaller, because they shrink with the tiles.
std::string surface_svg(const simulation::Surface& surface,
                        const simulation::Conditions* conditions = nullptr, const DrawnLabels& labels = {});

/// A deformed state, for drawings of several states over each other.
struct DeformedLayer {
    std::string label;   ///< text in the legend
    std::string colour;  ///< colour of the lines, "#rrggbb"
    LineSet lines;       ///< lines of the deformed state
};

/// Options of drawings of deformed states.
struct DeformedViewOptions {
    /// Factor on the displacements, stated on the drawing.
    double scale = 1.0;
    /// Joints of the surface, stated on the drawing.
    reduction::Joints joints = reduction::Joints::Centreline;
    ViewOptions view{};  ///< direction of the viewer
    LineSet rest{};      ///< lines drawn dashed below everything, such as rim_lines()
    /// Beams of a reduced model at rest, for the view from above in figure_svg(); empty: they are not shown.
    LineSet reduced{};
    DrawnLabels labels{};  ///< numbers on the drawing of the surface from above
};

/// The rim of a surface at rest.
LineSet rim_lines(const simulation::Surface& surface);

/// A drawing of deformed states over each other, in parallel projection, with a legend and a scale bar.
std::string deformed_svg(std::span<const DeformedLayer> layers, const DeformedViewOptions& options = {});

/// A drawing of one deformed state, coloured by the size of the displacements, with a legend. Lines nearer to
/// the viewer are drawn over the lines behind, with white edges.
std::string displacement_svg(const DeformedLayer& layer, const DeformedViewOptions& options = {});

/// A figure as wide as a journal's column (84 mm), in the order of the paper's Figs. 12 to 14: the surface
/// from above, beside it the beams of the reduced model (if `options` has them), the patterns, the surface
/// with supports and loads, and the deformed states. Text is at least 6 pt high; only numbers (DrawnLabels)
/// may be smaller. If there are more than 32 forces, 16 evenly spread ones are drawn, and the legend states
/// the number; the same holds for moments.
std::string figure_svg(const simulation::Surface& surface, const simulation::Conditions& conditions,
                       std::span<const DeformedLayer> layers, const DeformedViewOptions& options = {});

}  // namespace fretwork::exports
