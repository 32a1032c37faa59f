// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/simulation/derivatives/setting_rates.hpp>
#include <fretwork/simulation/detail/condensed_pattern.hpp>
#include <fretwork/simulation/detail/own_axes.hpp>

#include <array>
#include <map>
#include <string>
#include <utility>

namespace fretwork::simulation {
namespace {

TileRate rate_along(const std::function<detail::CondensedPattern(double)>& condensed, double step) {
    constexpr std::array<std::pair<int, double>, 4> kWeights = {
        {{-2, 1.0 / 12.0}, {-1, -8.0 / 12.0}, {1, 8.0 / 12.0}, {2, -1.0 / 12.0}}};
    TileRate rate;
    for (const auto& [place, weight] : kWeights) {
        const auto there = condensed(place * step);
        if (rate.stiffness.size() == 0)
            rate.stiffness.setZero(there.stiffness.rows(), there.stiffness.cols());
        rate.stiffness += weight / step * there.stiffness;
        rate.mass += weight / step * there.mass;
    }
    return rate;
}

}  // namespace

base::IndexVector<tiling::TileIndex, std::shared_ptr<const TileRate>> rates_along(
    const Surface& surface, const std::function<reduction::Setting(double)>& setting, double step) {
    const double grid = detail::congruence_grid(surface.tessellation);
    std::map<std::pair<std::string, std::string>, std::shared_ptr<const TileRate>> known;
    base::IndexVector<tiling::TileIndex, std::shared_ptr<const TileRate>> rates;
    for (const tiling::TileIndex tile : surface.tessellation.tiles.indices()) {
        const pattern::NamedPattern& pattern = tiling::painted_pattern_of(surface.tessellation, tile);
        const detail::TilePolygon place = detail::tile_polygon_of(surface, tile, grid);
        auto& shared = known[{place.key, pattern.id}];
        if (!shared) {
            const auto condensed = [&](double at) {
                return detail::condensed_pattern(surface.layout, pattern.pattern, place.polygon, setting(at));
            };
            shared = std::make_shared<const TileRate>(rate_along(condensed, step));
        }
        rates.push_back(shared);
    }
    return rates;
}

}  // namespace fretwork::simulation
