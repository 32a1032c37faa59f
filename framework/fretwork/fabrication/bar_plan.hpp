// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/fabrication/contour.hpp>
#include <fretwork/simulation/surface.hpp>
#include <fretwork/tiling/tessellation_fan.hpp>

#include <array>
#include <vector>

namespace fretwork::fabrication {

/// The index of a node of a surface's beams, as in tiling::TessellationFan.
using tiling::TessellationNodeIndex;
using tiling::TileIndex;

/// A bar: a beam as it is made, with its width.
struct Bar {
    std::array<TessellationNodeIndex, 2> nodes;  ///< the ends of the bar
    double width = 0.0;                          ///< m
    TileIndex tile;                              ///< the tile to which the bar belongs
};

/// The bars of a surface and their nodes. No two bars cross or lie over each other.
struct BarPlan {
    /// Positions of the nodes, m: the nodes of the tessellation's fan, then, if there is a border, all
    /// vertices of the tessellation.
    base::IndexVector<TessellationNodeIndex, geometry::Point2> nodes;
    std::vector<Bar> bars{};          ///< bars of all tiles, and bars of the border
    double width = 0.0;               ///< width of the surface's beams, m
    double height = 0.0;              ///< thickness of the sheet or print, m
    std::size_t interface_nodes = 0;  ///< number of interface nodes; these come first
    /// Two nodes at the same place, for example at a corner of three tiles. All bars there end at the node
    /// `taken`.
    /// The model's beams are not connected at this place, but the material is one piece.
    struct Coincidence {
        TessellationNodeIndex node;   ///< the unused node
        TessellationNodeIndex taken;  ///< the node that replaces `node`
    };
    std::vector<Coincidence> coincidences{};  ///< pairs of nodes at the same place
};

/// The rectangle with a section's radii of gyration: the section itself, if it is a rectangle.
struct Rectangle {
    double width = 0.0;   ///< width, in the plane of the surface, m
    double height = 0.0;  ///< height, across the plane, m
};
/// The equivalent rectangle of a section. Throws InputError if its width or height is not above zero.
Rectangle equivalent_rectangle(const mechanics::Section& section);

/// The bars of a surface. If `frame_width` (m) is not zero, bars of that width along the rim form a border.
///
/// Throws InputError or GeometryError if the tessellation is not valid (tiling::validate()), if a tile is not
/// painted, if a beam's width or length is zero, if beams cross or lie over each other, or if a bar lies
/// along the border. Messages about tiles name them. Throws InputError if `frame_width` is below zero or not
/// finite, or if the surface has no beams.
BarPlan bar_plan(const simulation::Surface& surface, double frame_width = 0.0);

}  // namespace fretwork::fabrication
