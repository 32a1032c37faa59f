// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/reduction/models/full_tile.hpp>
#include <fretwork/reduction/response.hpp>

namespace fretwork::reduction {

TileModel full_tile_model() {
    return {.name = "full",
            .summary = "every beam of every pattern, geometrically nonlinear",
            .role = Role::Reference,
            .displacements = Displacements::Large,
            .build = [](const TileInput& input) {
                return beam_tile(fan_frame(input.layout, input.fan, input.polygon, input.setting),
                                 input.fan->interface_node_count, TileBeams::OfThePattern);
            }};
}

}  // namespace fretwork::reduction
