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
    double azimuth = -0.6;   ///< rad, about z
    double elevation = 0.6;  ///< rad above the plane
};

/// The numbers shown on a drawing.
struct DrawnLabels {
    /// Whether numbers are drawn.
    enum class Shown { No, Yes };
    Shown tiles = Shown::No;            ///< numbers of tiles
    Shown interface_nodes = Shown::No;  ///< numbers of interface nodes
};

/// A surface seen from above at true scale, as in the paper's Figs. 12 to 14: tiles coloured by pattern,
/// beams of true width, a legend and a scale bar. Tiles without a pattern are empty. Given `conditions`, it
/// also shows supports (red: all dofs, green: translations only, orange: others) and loads (arrows; forces
/// out of the plane as rings).
std::string surface_svg(const simulation::Surface& surface,
                        const simulation::Conditions* conditions = nullptr, const DrawnLabels& labels = {});

/// One of several deformed states drawn over each other.
struct DeformedLayer {
    std::string label;   ///< for the legend
    std::string colour;  ///< "#rrggbb"
    LineSet lines;       ///< displaced
};

/// Options of drawings of deformed states.
struct DeformedViewOptions {
    double scale = 1.0;                                        ///< factor on the displacements; the drawing
                                                               ///< states it
    reduction::Joints joints = reduction::Joints::Centreline;  ///< joints of the surface; the drawing states
                                                               ///< them
    ViewOptions view{};                                        ///< from where
    LineSet rest{};        ///< lines drawn dashed below everything, such as rim_lines()
    DrawnLabels labels{};  ///< numbers on the surface from above
};

/// The rim of a surface at rest.
LineSet rim_lines(const simulation::Surface& surface);

/// Deformed states in parallel projection, over each other, with a legend and a scale bar.
std::string deformed_svg(std::span<const DeformedLayer> layers, const DeformedViewOptions& options = {});

/// One deformed state, with the size of the displacements as colours and a legend. Lines nearer to the viewer
/// are drawn over lines behind them, with white edges.
std::string displacement_svg(const DeformedLayer& layer, const DeformedViewOptions& options = {});

/// A sheet with three drawings below each other, as in the paper's Figs. 12 to 14: the surface from above,
/// the setup, and the deformed states.
std::string figure_svg(const simulation::Surface& surface, const simulation::Conditions& conditions,
                       std::span<const DeformedLayer> layers, const DeformedViewOptions& options = {});

}  // namespace fretwork::exports
