// SPDX-License-Identifier: GPL-3.0-or-later
#include "corotational_frame.hpp"

#include <fretwork/mechanics/condensation.hpp>
#include <fretwork/reduction/models/corotational_tile.hpp>

#include <utility>

namespace fretwork::tile_models {
namespace {

using reduction::TileInput;
using reduction::TileModel;

std::shared_ptr<const reduction::TileStructure> turning_tile(const TileModel& linear,
                                                             const TileInput& input) {
    const auto tile = linear.build(input);
    const auto places = pattern::place_fan(input.layout, input.fan, input.polygon);
    mechanics::CorotationalBody::Parts parts;
    for (int i = 0; i < input.fan->interface_node_count; ++i) {
        const geometry::Point2& place = places[i];
        parts.nodes.emplace_back(place.x, place.y, 0.0);
    }
    parts.stiffness = mechanics::condense(assemble(tile_parts(*tile, parts.nodes)),
                                          mechanics::first_nodes(input.fan->interface_node_count));
    return reduction::corotational_tile(std::move(parts));
}

}  // namespace

TileModel corotational(TileModel linear) {
    TileModel row = linear;
    row.name = "corotational_" + linear.name;
    row.summary = linear.name + " in a frame that turns with each tile; large displacements";
    row.displacements = reduction::Displacements::Large;
    row.sharing = reduction::Sharing::Congruent;
    row.build = [linear = std::move(linear)](const TileInput& input) { return turning_tile(linear, input); };
    return row;
}

}  // namespace fretwork::tile_models
