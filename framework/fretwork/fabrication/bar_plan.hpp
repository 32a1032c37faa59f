// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/fabrication/contour.hpp>
#include <fretwork/simulation/surface.hpp>
#include <fretwork/tiling/tessellation_fan.hpp>

#include <array>
#include <vector>

namespace fretwork::fabrication {

/// A node of a surface's beams, by its number in tiling::TessellationFan.
using tiling::TessellationNodeIndex;
using tiling::TileIndex;

/// A beam with its width, as it is made.
struct Bar {
    std::array<TessellationNodeIndex, 2> nodes;  ///< its ends
    double width = 0.0;                          ///< m
    TileIndex tile;                              ///< whose bar it is
};

/// The bars of a surface, and where they meet. No two bars cross or lie over each other.
struct BarPlan {
    /// m; the nodes of the tessellation's fan, then those of the border
    base::IndexVector<TessellationNodeIndex, geometry::Point2> nodes;
    std::vector<Bar> bars{};          ///< of all tiles, and of the frame
    double width = 0.0;               ///< m, width of the surface's beams
    double height = 0.0;              ///< m, thickness of the sheet or print
    std::size_t interface_nodes = 0;  ///< number of interface nodes, which come first
    /// A node at the same place as another node, such as a corner where three tiles meet. Bars end at the
    /// other node (`taken`). The model's beams are not joined there, but the material is one piece.
    struct Coincidence {
        TessellationNodeIndex node;   ///< which is left out
        TessellationNodeIndex taken;  ///< which stands for it
    };
    std::vector<Coincidence> coincidences{};  ///< nodes at one place
};

/// The width and height of the rectangle with a section's area and second moments, m.
struct Rectangle {
    double width = 0.0;   ///< m, in the plane
    double height = 0.0;  ///< m, across it
};
/// The equivalent rectangle of a section. Throws InputError if its width or height is not above zero.
Rectangle equivalent_rectangle(const mechanics::Section& section);

/// The bars of a surface. If `frame_width` (m) is not zero, bars of this width along the rim form a border.
///
/// Throws InputError or GeometryError that names the tile if a tile is not painted or not closed, if a beam's
/// width or length is zero, if beams cross or lie over each other, or if a bar lies along the border.
BarPlan bar_plan(const simulation::Surface& surface, double frame_width = 0.0);

}  // namespace fretwork::fabrication
