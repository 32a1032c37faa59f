// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/mechanics/node_states.hpp>
#include <fretwork/simulation/detail/tile_deformations.hpp>

#include <algorithm>

namespace fretwork::simulation::detail {

std::vector<TileDeformation> tile_deformations(const mechanics::Assembly& assembly,
                                               std::span<const TileStart> starts,
                                               const mechanics::Solution& solution,
                                               const base::Control& control) {
    const std::vector<mechanics::NodeState> states = mechanics::node_states(solution.displacements);
    std::vector<TileDeformation> tiles(starts.size() - 1);
    std::vector<mechanics::NodeState> own;
    mechanics::ElementResponse response;
    for (std::size_t t = 0; t < tiles.size(); ++t) {
        control.check();
        const std::size_t first = first_element(assembly, starts, tiling::TileIndex(t));
        const std::size_t count = starts[t + 1].element - starts[t].element;
        for (std::size_t e = 0; e < count; ++e) {
            const mechanics::Element& element = *assembly.elements[first + e];
            own.clear();
            for (const mechanics::NodeIndex node : element.nodes()) own.push_back(states[node]);
            element.evaluate(own, mechanics::Demand::Force, response);
            tiles[t].energy += response.energy;
            tiles[t].rotation = std::max(tiles[t].rotation, element.relative_turn(own));
        }
    }
    return tiles;
}

}  // namespace fretwork::simulation::detail
