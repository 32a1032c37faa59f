// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/design/search/tile_groups.hpp>
#include <fretwork/geometry/plane.hpp>
#include <fretwork/tiling/painting/tile_choice.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>

namespace fretwork::design::detail {
namespace {

using geometry::Point2;
using tiling::Tessellation;
using tiling::TileIndex;

/// The largest distance of an image's middle from a tile's, as a share of the mean tile side.
constexpr double kNear = 0.2;

class Images {
  public:
    Images(const Tessellation& tessellation, const Symmetry& symmetry) : symmetry_(symmetry) {
        middles_ = tiling::tile_centers(tessellation);
        middle_ = tiling::bounding_box(tessellation).middle();
        reach_ = kNear * tiling::mean_tile_side(tessellation);
    }
    /// The tile on which the image of the given tile lies.
    [[nodiscard]] TileIndex of(TileIndex tile) const {
        const Point2 image = image_of(middles_[tile]);
        for (std::size_t t = 0; t < middles_.size(); ++t) {
            if (geometry::distance(middles_[t], image) <= reach_) return TileIndex(t);
        }
        throw base::InputError("the tiles are not symmetric by " + symmetry_text(symmetry_) + ": tile " +
                               std::to_string(tile.value) + " has no image");
    }

  private:
    [[nodiscard]] Point2 image_of(const Point2& point) const {
        const double x = point.x - middle_.x;
        const double y = point.y - middle_.y;
        if (symmetry_.kind == Symmetry::Kind::MirrorX) return {middle_.x - x, point.y};
        if (symmetry_.kind == Symmetry::Kind::MirrorY) return {point.x, middle_.y - y};
        const double turn = 2.0 * std::numbers::pi / symmetry_.folds;
        return {middle_.x + std::cos(turn) * x - std::sin(turn) * y,
                middle_.y + std::sin(turn) * x + std::cos(turn) * y};
    }

    Symmetry symmetry_;
    base::IndexVector<TileIndex, Point2> middles_;
    Point2 middle_{};
    double reach_ = 0.0;
};

}  // namespace

std::vector<TileGroup> tile_groups(const Tessellation& tessellation, std::span<const TileIndex> kept,
                                   const Symmetry& symmetry) {
    std::vector<bool> is_kept(tessellation.tiles.size(), false);
    for (const TileIndex tile : kept) is_kept[static_cast<std::size_t>(tile.value)] = true;
    std::optional<Images> images;
    if (symmetry.kind != Symmetry::Kind::None) images.emplace(tessellation, symmetry);
    const bool mirrors = symmetry.kind == Symmetry::Kind::MirrorX || symmetry.kind == Symmetry::Kind::MirrorY;
    std::vector<bool> is_done = is_kept;
    std::vector<TileGroup> groups;
    for (const TileIndex first : tessellation.tiles.indices()) {
        if (is_done[static_cast<std::size_t>(first.value)]) continue;
        TileGroup& group = groups.emplace_back();
        bool is_mirrored = false;
        for (TileIndex tile = first; !is_done[static_cast<std::size_t>(tile.value)];) {
            is_done[static_cast<std::size_t>(tile.value)] = true;
            group.members.push_back({tile, is_mirrored});
            if (!images) break;
            const TileIndex image = images->of(tile);
            if (is_kept[static_cast<std::size_t>(image.value)])
                throw base::InputError("tile " + std::to_string(image.value) +
                                       " is kept, and its image, tile " + std::to_string(tile.value) +
                                       ", is not: no painting is symmetric");
            tile = image;
            is_mirrored = is_mirrored != mirrors;
        }
    }
    return groups;
}

std::set<std::size_t> kept_candidates(const simulation::CandidateTiles& candidates,
                                      const tiling::Tessellation& tessellation,
                                      const std::vector<tiling::TileIndex>& keep) {
    std::set<std::size_t> kept;
    const auto& all = candidates.patterns();
    for (const tiling::TileIndex tile : keep) {
        const auto* own = tiling::pattern_of(tessellation, tile);
        kept.insert(static_cast<std::size_t>(std::ranges::find(all, own->id, &pattern::NamedPattern::id) -
                                             all.begin()));
    }
    return kept;
}

}  // namespace fretwork::design::detail
