// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of drawings of a surface.
#pragma once

#include <fretwork/exports/drawings/detail/projection.hpp>
#include <fretwork/exports/drawings/detail/svg_canvas.hpp>
#include <fretwork/exports/drawings/surface_drawing.hpp>

#include <string>
#include <vector>

namespace fretwork::exports::detail {

/// The width of a beam as seen from above: that of a square of the section's area.
double beam_width(const simulation::Surface& surface);

void draw_tiles(SvgCanvas& canvas, const simulation::Surface& surface, const Projection& projection);
/// Numbers of tiles in their middles, of interface nodes beside them, from above.
void draw_labels(SvgCanvas& canvas, const simulation::Surface& surface, const DrawnLabels& labels);
void draw_beams(SvgCanvas& canvas, const simulation::Surface& surface, const Projection& projection);

/// A support as it is drawn, and as a legend calls it.
struct SupportMark {
    geometry::Point2 place;
    Colour colour;
    std::string meaning;
};
std::vector<SupportMark> support_marks(const simulation::Surface& surface,
                                       const simulation::Conditions& conditions,
                                       const Projection& projection);

/// A force or a moment as it is drawn: an arrow, or, where it would point at the viewer or away, a ring.
struct LoadMark {
    enum class Kind { Force, Moment };
    enum class Shape { Arrow, TowardsViewer, AwayFromViewer };
    Kind kind = Kind::Force;
    Shape shape = Shape::Arrow;
    geometry::Point2 from;  ///< tail of the arrow, or center of the ring
    geometry::Point2 to;    ///< head
    double size = 0.0;      ///< of the arrow in space, metres
};
/// The loads of a case with those on one node added up, by the nodes' numbers.
std::vector<mechanics::NodalLoad> loads_by_node(const simulation::Conditions& conditions);
/// Marks for the loads of all nodes, the largest force and the largest moment as large as `reach`. A force
/// that comes from above or lies in the plane ends at its node; one that goes up starts there. A moment has
/// its node in the middle.
std::vector<LoadMark> load_marks(const simulation::Surface& surface, const simulation::Conditions& conditions,
                                 const Projection& projection, double reach);

void draw_support(SvgCanvas& canvas, const SupportMark& mark, double radius);
void draw_load(SvgCanvas& canvas, const LoadMark& mark);

}  // namespace fretwork::exports::detail
