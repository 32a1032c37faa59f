// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/mechanics/condensation.hpp>
#include <fretwork/mechanics/paths/equilibrium.hpp>
#include <fretwork/reduction/calibration/model_response.hpp>

namespace fretwork::reduction {

ModelTile::ModelTile(base::Borrowed<TileModel> model, base::Borrowed<pattern::NodeLayout> layout,
                     const pattern::Pattern& pattern, base::Borrowed<Setting> setting)
    : model_(model),
      layout_(layout),
      setting_(setting),
      polygon_(geometry::regular_polygon(setting->sides, setting->tile_side)),
      fan_(pattern::make_fan(layout, pattern, setting->sides)) {
    const auto places = pattern::place_fan(layout, fan_, polygon_);
    for (int i = 0; i < fan_.interface_node_count; ++i) {
        const geometry::Point2& place = places[i];
        interface_nodes_.emplace_back(place.x, place.y, 0.0);
    }
}

StructureParts ModelTile::parts(std::span<const double> parameters) const {
    const auto tile = build_tile(model_, {layout_, fan_, setting_, polygon_, parameters});
    return tile_parts(*tile, interface_nodes_);
}

UnitDisplacements ModelTile::displacements(std::span<const double> parameters) const {
    const auto kept = mechanics::first_nodes(static_cast<int>(interface_nodes_.size()));
    return unit_displacements(mechanics::condense(assemble(parts(parameters)), kept), setting_);
}

std::vector<Response> ModelTile::responses(std::span<const double> parameters,
                                           const base::Control& control) const {
    std::vector<Response> responses;
    const mechanics::Assembly tile = assemble(parts(parameters));
    const int interface_nodes = fan_.interface_node_count;
    for (const Scenario& scenario : setting_->scenarios) {
        const Scenario spread = spread_over_sides(scenario, interface_nodes / setting_->sides);
        mechanics::Assembly loaded = tile;
        apply_scenario(spread, loaded);
        responses.push_back(follow_scenario({loaded, interface_nodes}, spread, setting_, control.silent()));
    }
    return responses;
}

}  // namespace fretwork::reduction
