// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/simulation/mixed_model.hpp>

#include <algorithm>
#include <cmath>
#include <functional>

namespace fretwork::simulation {

std::vector<tiling::TileIndex> worst_tiles(std::span<const TileDeformation> tiles, double share) {
    constexpr double kRounding = 1e-9;  // so that 0.07 of 100 is 7, not 8
    const auto product = [&](tiling::TileIndex tile) {
        const TileDeformation& deformation = tiles[tile];
        return deformation.energy * deformation.rotation;
    };
    std::vector<tiling::TileIndex> worst;
    for (std::size_t t = 0; t < tiles.size(); ++t) {
        if (product(tiling::TileIndex(t)) > 0.0) worst.emplace_back(t);
    }
    std::ranges::stable_sort(worst, std::greater(), product);
    const double count = std::ceil(share * static_cast<double>(tiles.size()) - kRounding);
    if (count < static_cast<double>(worst.size())) worst.resize(static_cast<std::size_t>(count));
    return worst;
}

std::vector<tiling::TileIndex> worst_tiles(const Surface& surface, std::span<const TileDeformation> tiles,
                                           double share) {
    std::vector<TileDeformation> free(tiles.begin(), tiles.end());
    for (std::size_t t = 0; t < surface.tile_models.size(); ++t) {
        if (!surface.tile_models[t].empty()) free[t] = {};
    }
    std::vector<tiling::TileIndex> worst = worst_tiles(free, share);
    std::ranges::sort(worst);
    return worst;
}

}  // namespace fretwork::simulation
