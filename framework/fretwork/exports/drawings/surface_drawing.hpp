// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/exports/tables/line_set.hpp>
#include <fretwork/simulation/load_cases/conditions.hpp>
#include <fretwork/simulation/surface.hpp>

#include <span>
#include <string>

namespace fretwork::exports {

/// Where the viewer of a parallel projection stands.
struct ViewOptions {
    double azimuth = -0.6;   ///< rad, about z
    double elevation = 0.6;  ///< rad above the plane
};

/// Numbers on a drawing.
struct DrawnLabels {
    enum class Shown { No, Yes };
    Shown tiles = Shown::No;
    Shown interface_nodes = Shown::No;
};

/// A surface seen from above at true scale: tiles coloured by pattern, beams of true width, and, where
/// `conditions` are given, supports (red: all dofs, green: translations only, orange: others) and loads
/// (arrows; forces out of the plane as rings). With a legend and a scale bar. Tiles without a pattern are
/// empty. As in the paper's Figs. 12 to 14.
std::string surface_svg(const simulation::Surface& surface,
                        const simulation::Conditions* conditions = nullptr, const DrawnLabels& labels = {});

/// One of the deformed states that are drawn over each other.
struct DeformedLayer {
    std::string label;   ///< for the legend
    std::string colour;  ///< "#rrggbb"
    LineSet lines;
};

struct DeformedViewOptions {
    double scale = 1.0;                                        ///< of the displacements; the drawing says it
    reduction::Joints joints = reduction::Joints::Centreline;  ///< of the surface; the drawing says it
    ViewOptions view{};
    LineSet rest{};        ///< drawn dashed below everything, such as rim_lines()
    DrawnLabels labels{};  ///< on the surface from above
};

/// The rim of a surface at rest.
LineSet rim_lines(const simulation::Surface& surface);

/// Deformed states in parallel projection, over each other, with a legend and a scale bar.
std::string deformed_svg(std::span<const DeformedLayer> layers, const DeformedViewOptions& options = {});

/// The displacements' size on the deformed state of one layer, as colours with a legend. Lines that are
/// nearer to the viewer are drawn over those behind them, with white edges.
std::string displacement_svg(const DeformedLayer& layer, const DeformedViewOptions& options = {});

/// All of it below each other on one sheet, as the paper's Figs. 12 to 14: from above, the setup, the
/// deformed states.
std::string figure_svg(const simulation::Surface& surface, const simulation::Conditions& conditions,
                       std::span<const DeformedLayer> layers, const DeformedViewOptions& options = {});

}  // namespace fretwork::exports
