// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/parallel.hpp>
#include <fretwork/simulation/detail/own_axes.hpp>
#include <fretwork/simulation/detail/tile_builder.hpp>

#include <set>

namespace fretwork::simulation::detail {
namespace {

using reduction::TileStructure;

std::string key_of(const reduction::TileModel& model, const std::string& pattern, const OwnAxes& axes) {
    std::string key = model.name + '\0' + pattern + '\0';
    key.append(reinterpret_cast<const char*>(axes.steps.data()), axes.steps.size() * sizeof(std::int64_t));
    return key;
}

}  // namespace

/// A tile that is to be built, or to be taken from the shared tiles.
struct TileBuilder::Request {
    const reduction::TileModel* model;
    const pattern::Fan* fan;
    std::vector<double> parameters;
    geometry::Polygon polygon;  ///< in the axes in which the tile is built
    std::string key;            ///< key of a shared tile; empty: not shared
    std::string place;          ///< the tile and its pattern, for messages
    BuiltTile tile;

    [[nodiscard]] std::shared_ptr<const TileStructure> build(const Surface& surface) const {
        return reduction::build_tile(*model, {surface.layout, *fan, surface.setting, polygon, parameters});
    }
};

const pattern::Fan& TileBuilder::fan_of(const Surface& surface, const tiling::Tile& tile) {
    const auto& pattern = surface.tessellation.patterns[tile.pattern];
    const std::size_t sides = tile.vertices.size();
    const auto [entry, is_new] = fans_.try_emplace({pattern.id, sides});
    if (is_new) entry->second = pattern::make_fan(surface.layout, pattern.pattern, static_cast<int>(sides));
    return entry->second;
}

TileBuilder::Request TileBuilder::request(const TilesToBuild& wanted, tiling::TileIndex index, double grid) {
    const Surface& surface = wanted.surface;
    const tiling::Tile& tile = surface.tessellation.tiles[index];
    const reduction::TileModel& model = tile_model(surface, wanted.choice, index);
    const std::string& pattern = tiling::pattern_of(surface.tessellation, index)->id;
    std::vector<double> parameters = tile_parameters(surface, index, model);
    Request request{&model,
                    &fan_of(surface, tile),
                    std::move(parameters),
                    tiling::tile_polygon(surface.tessellation, index),
                    {},
                    "tile " + std::to_string(index.value) + ", pattern " + pattern,
                    {}};
    if (model.sharing == reduction::Sharing::None) return request;
    std::optional<OwnAxes> axes = shared_axes(request.polygon, grid);
    if (!axes) return request;
    request.key = key_of(model, pattern, *axes);
    request.polygon = std::move(axes->polygon);
    request.tile.turn = axes->turn;
    request.tile.origin = axes->origin;
    return request;
}

void TileBuilder::drop_unused() {
    std::erase_if(shared_, [](const auto& entry) { return entry.second.use_count() == 1; });
    fans_.clear();
    looked_at_size_ = shared_.size() + kMostUnused;
}

std::vector<BuiltTile> TileBuilder::build(const TilesToBuild& wanted, const BuildOptions& options) {
    if (shared_.size() > looked_at_size_) drop_unused();
    const double grid = congruence_grid(wanted.surface.tessellation);
    std::vector<Request> requests;
    requests.reserve(wanted.tiles.size());  // pointers to them, and views of their keys, are kept
    std::vector<Request*> missing;
    std::set<std::string_view> missing_keys;
    for (const tiling::TileIndex tile : wanted.tiles) {
        options.control.check();
        Request& next = requests.emplace_back(request(wanted, tile, grid));
        const bool is_there = shared_.contains(next.key);
        if (next.key.empty() || (!is_there && missing_keys.insert(next.key).second)) missing.push_back(&next);
    }
    base::parallel_for(missing.size(), options.threads, [&](std::size_t i) {
        options.control.check();
        missing[i]->tile.structure = base::located<base::NumericalError>(
            missing[i]->place, "", [&] { return missing[i]->build(wanted.surface); });
    });
    for (const Request* request : missing) {
        if (!request->key.empty()) shared_[request->key] = request->tile.structure;
    }
    built_count_ += missing.size();
    std::vector<BuiltTile> built;
    for (Request& request : requests) {
        if (!request.tile.structure) request.tile.structure = shared_.at(request.key);
        built.push_back(std::move(request.tile));
    }
    return built;
}

std::vector<BuiltTile> TileBuilder::build_all(const Surface& surface, const ModelChoice& choice,
                                              const BuildOptions& options) {
    std::vector<tiling::TileIndex> tiles;
    for (std::size_t t = 0; t < surface.tessellation.tiles.size(); ++t) tiles.emplace_back(t);
    return build({surface, choice, tiles}, options);
}

}  // namespace fretwork::simulation::detail
