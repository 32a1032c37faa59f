// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/mechanics/condensation.hpp>
#include <fretwork/reduction/detail/rigid_motions.hpp>
#include <fretwork/reduction/models/condensed_tile.hpp>

#include <memory>
#include <utility>
#include <vector>

namespace fretwork::reduction {
namespace {

void require_beams_at_interface(const mechanics::Frame& tile, int interface_nodes) {
    std::vector<bool> has_beam(tile.nodes.size(), false);
    for (const mechanics::Beam& beam : tile.beams) {
        for (const mechanics::NodeIndex node : beam.nodes) has_beam[node] = true;
    }
    for (int i = 0; i < interface_nodes; ++i) {
        if (has_beam[i]) continue;
        throw base::InputError("interface node " + std::to_string(i) +
                               " has no beam: the pattern does not connect the tile to its neighbours");
    }
}

}  // namespace

Eigen::MatrixXd condensed_frame(const mechanics::Frame& tile, int interface_nodes) {
    require_beams_at_interface(tile, interface_nodes);
    return mechanics::condense(mechanics::assemble(tile), mechanics::first_nodes(interface_nodes));
}

TileModel condensed_tile_model() {
    return {.name = "condensed",
            .summary = "the beams of each tile, condensed onto its interface nodes; linear",
            .sharing = Sharing::Congruent,
            .build = [](const TileInput& input) {
                const int interface_nodes = input.fan->interface_node_count;
                mechanics::Frame beams = fan_frame(input.layout, input.fan, input.polygon, input.setting);
                Eigen::MatrixXd stiffness = condensed_frame(beams, interface_nodes);
                detail::require_small_rounding(stiffness, beams, interface_nodes);
                return stiffness_tile(std::move(stiffness),
                                      std::make_shared<InnerNodes>(std::move(beams), interface_nodes));
            }};
}

}  // namespace fretwork::reduction
