// SPDX-License-Identifier: GPL-3.0-or-later
#include "corotational_frame.hpp"

#include <fretwork/mechanics/condensation.hpp>
#include <fretwork/mechanics/corotational_element.hpp>

#include <memory>
#include <utility>

namespace fretwork::tile_models {
namespace {

using reduction::TileInput;
using reduction::TileModel;

class TurningTile final : public reduction::TileStructure {
  public:
    explicit TurningTile(mechanics::CorotationalBody::Parts parts)
        : body_(std::make_shared<mechanics::CorotationalBody>(std::move(parts))) {}

    [[nodiscard]] std::span<const Eigen::Vector3d> inner_nodes() const override { return {}; }
    void add_to(reduction::StructureParts& surface, const reduction::TilePlace& place) const override {
        surface.elements.push_back(
            mechanics::corotational_element({place.nodes.begin(), place.nodes.end()}, body_, place.turn));
    }
    [[nodiscard]] std::optional<reduction::BeamMotion> beam_motion(
        const reduction::TileMotion&) const override {
        return std::nullopt;
    }

  private:
    std::shared_ptr<const mechanics::CorotationalBody> body_;
};

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
    return std::make_shared<TurningTile>(std::move(parts));
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
