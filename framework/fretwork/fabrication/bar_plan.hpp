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

/// A beam as it is made: with its width.
struct Bar {
    std::array<TessellationNodeIndex, 2> nodes;
    double width = 0.0;  ///< m
    TileIndex tile;
};

/// The bars of a surface, and where they meet. No two bars cross or lie over each other.
struct BarPlan {
    /// m; those of the tessellation's fan, then those of a frame
    base::IndexVector<TessellationNodeIndex, geometry::Point2> nodes;
    std::vector<Bar> bars{};
    double width = 0.0;               ///< m, of the surface's beams
    double height = 0.0;              ///< m, thickness of the sheet or print
    std::size_t interface_nodes = 0;  ///< the first nodes
    /// Nodes that lie where another one does, such as corners where three tiles meet: bars end at that other
    /// one. The beams of a model are not joined there; what is made is one piece.
    struct Coincidence {
        TessellationNodeIndex node;
        TessellationNodeIndex taken;
    };
    std::vector<Coincidence> coincidences{};
};

/// Width and height of the rectangle that has a section's area and second moments, m.
struct Rectangle {
    double width = 0.0;
    double height = 0.0;
};
/// Throws InputError if the section has no width or no height.
Rectangle equivalent_rectangle(const mechanics::Section& section);

/// The bars of a surface; with a frame of the given width (m) along its rim if that is not zero.
///
/// Throws InputError or GeometryError that names the tile: tiles that are not painted or do not close, beams
/// without width, longer than nothing, that cross or lie over each other, and frames that a bar lies along.
BarPlan bar_plan(const simulation::Surface& surface, double frame_width = 0.0);

}  // namespace fretwork::fabrication
