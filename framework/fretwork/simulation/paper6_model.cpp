// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/reduction/paper6_tile.hpp>
#include <fretwork/simulation/model_catalogue.hpp>

namespace fretwork::simulation {
namespace {

using mechanics::NodeIndex;

const reduction::Paper6Parameters& parameters_of(const Surface& surface, const tiling::Tile& tile) {
    const auto pattern = static_cast<std::size_t>(tile.pattern);
    if (const auto& calibration = surface.calibrations[pattern]) return calibration->parameters;
    throw base::InputError("pattern " + surface.tessellation.patterns[pattern] +
                           " has no calibration of the paper's model: name a library that has it "
                           "('fretwork calibrate' makes one)");
}

/// Append a tile's frame, whose first nodes are the tile's interface nodes, to that of the surface.
void append_tile(mechanics::Frame& frame, const tiling::Tile& tile, const mechanics::Frame& part) {
    const std::size_t interface_count = tile.interface_nodes.size();
    const std::size_t first_inner = frame.nodes.size();
    frame.nodes.insert(frame.nodes.end(), part.nodes.begin() + static_cast<std::ptrdiff_t>(interface_count),
                       part.nodes.end());
    const auto number = [&](NodeIndex node) {
        const auto i = static_cast<std::size_t>(node);
        return i < interface_count ? NodeIndex(tile.interface_nodes[i].value)
                                   : NodeIndex(first_inner + i - interface_count);
    };
    for (mechanics::Beam beam : part.beams) {
        beam.nodes = {number(beam.nodes[0]), number(beam.nodes[1])};
        frame.beams.push_back(std::move(beam));
    }
}

}  // namespace

mechanics::Frame paper6_model_frame(const Surface& surface, const Conditions& conditions) {
    mechanics::Frame frame;
    for (const pattern::Point2& node : surface.tessellation.interface_nodes)
        frame.nodes.emplace_back(node.x, node.y, 0.0);
    for (std::size_t t = 0; t < surface.tessellation.tiles.size(); ++t) {
        const tiling::Tile& tile = surface.tessellation.tiles[t];
        const auto polygon = tiling::tile_polygon(surface.tessellation, tiling::TileIndex(t));
        append_tile(frame, tile,
                    reduction::paper6_tile(parameters_of(surface, tile), surface.setting, polygon));
    }
    frame.supports = conditions.supports;
    frame.prescribed = conditions.prescribed;
    frame.loads = conditions.loads;
    return frame;
}

mechanics::Assembly build_paper6_model(const Surface& surface, const Conditions& conditions) {
    return mechanics::assemble(paper6_model_frame(surface, conditions));
}

}  // namespace fretwork::simulation
