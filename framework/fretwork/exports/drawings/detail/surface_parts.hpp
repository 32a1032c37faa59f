// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of drawings of a surface.
#pragma once

#include <fretwork/exports/drawings/detail/projection.hpp>
#include <fretwork/exports/drawings/detail/svg_canvas.hpp>
#include <fretwork/exports/drawings/surface_drawing.hpp>

#include <string>
#include <vector>

namespace fretwork::exports::detail {

/// The width with which beams are drawn, m: the side of a square with the section's area.
double beam_width(const simulation::Surface& surface);

/// Colours of a surface: tiles in the colours of their patterns, or pale tiles and beams on which marks stand
/// out.
enum class Tint { Patterns, Pale };
void draw_tiles(SvgCanvas& canvas, const simulation::Surface& surface, const Projection& projection,
                Tint tint);
/// Draw, from above, the numbers of tiles in the tiles' middles, and the numbers of interface nodes beside
/// the nodes.
void draw_labels(SvgCanvas& canvas, const simulation::Surface& surface, const DrawnLabels& labels);
void draw_beams(SvgCanvas& canvas, const simulation::Surface& surface, const Projection& projection,
                Tint tint);

/// The supports of nodes: all components that entries of a node hold.
std::vector<mechanics::Support> supports_of_nodes(const simulation::Conditions& conditions);

/// The mark of a support, and its meaning in a legend.
struct SupportMark {
    geometry::Point2 place;
    Colour colour;
    std::string meaning;
};
std::vector<SupportMark> support_marks(const simulation::Surface& surface,
                                       const simulation::Conditions& conditions,
                                       const Projection& projection);

/// The nodes with prescribed displacements or rotations, each once.
std::vector<geometry::Point2> prescribed_marks(const simulation::Surface& surface,
                                               const simulation::Conditions& conditions,
                                               const Projection& projection);

/// The force and the moment on each node: all loads on it added up, with its shares of the weight.
std::vector<mechanics::NodalLoad> loads_of_nodes(const simulation::Conditions& conditions);

/// The mark of a force or a moment: an arrow or, if the arrow would point to or from the viewer, a ring.
struct LoadMark {
    enum class Kind { Force, Moment };
    enum class Shape { Arrow, TowardsViewer, AwayFromViewer };
    Kind kind = Kind::Force;
    Shape shape = Shape::Arrow;
    geometry::Point2 from;  ///< tail of the arrow, or center of the ring
    geometry::Point2 to;    ///< head
    double size = 0.0;      ///< of the arrow in space, metres
};
/// Marks for the loads of all nodes. The arrows of the largest force and of the largest moment have the
/// length `reach` in space. A force that points clearly upwards starts at its node; any other force ends
/// there. A moment has its node in the middle.
std::vector<LoadMark> load_marks(const simulation::Surface& surface, const simulation::Conditions& conditions,
                                 const Projection& projection, double reach);

void draw_support(SvgCanvas& canvas, const SupportMark& mark, double radius);
/// A diamond.
void draw_prescribed(SvgCanvas& canvas, const geometry::Point2& place, double radius);
void draw_load(SvgCanvas& canvas, const LoadMark& mark);

}  // namespace fretwork::exports::detail
