// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/mechanics/condensation.hpp>
#include <fretwork/mechanics/corotational_element.hpp>
#include <fretwork/reduction/condensed_tile.hpp>
#include <fretwork/reduction/corotational_tile.hpp>
#include <fretwork/reduction/response.hpp>

#include <utility>
#include <vector>

namespace fretwork::reduction {
namespace {

class CorotationalTile final : public TileStructure {
  public:
    explicit CorotationalTile(mechanics::CorotationalBody::Parts parts)
        : body_(std::make_shared<mechanics::CorotationalBody>(std::move(parts))) {}

    [[nodiscard]] std::span<const Eigen::Vector3d> inner_nodes() const override { return {}; }

    void add_to(StructureParts& surface, const TilePlace& place) const override {
        surface.elements.push_back(
            mechanics::corotational_element({place.nodes.begin(), place.nodes.end()}, body_, place.turn));
    }

  private:
    std::shared_ptr<const mechanics::CorotationalBody> body_;
};

}  // namespace

std::shared_ptr<const TileStructure> corotational_tile(mechanics::Frame tile, int interface_nodes) {
    mechanics::CorotationalBody::Parts parts{{tile.nodes.begin(), tile.nodes.begin() + interface_nodes},
                                             condensed_frame(tile, interface_nodes)};
    parts.mass = [tile = std::move(tile), interface_nodes] {
        std::vector<mechanics::NodeIndex> kept;
        for (int i = 0; i < interface_nodes; ++i) kept.emplace_back(i);
        return mechanics::condense_mass(mechanics::assemble(tile), kept);
    };
    return std::make_shared<CorotationalTile>(std::move(parts));
}

TileModel corotational_tile_model() {
    return {
        .name = "corotational",
        .summary = "the condensed stiffness of each tile in a frame that turns with it; large displacements",
        .displacements = Displacements::Large,
        .sharing = Sharing::Congruent,
        .build = [](const TileInput& input) {
            return corotational_tile(fan_frame(input.layout, input.fan, input.polygon,
                                               {input.setting.section, input.setting.material}),
                                     input.fan.interface_node_count);
        }};
}

}  // namespace fretwork::reduction
