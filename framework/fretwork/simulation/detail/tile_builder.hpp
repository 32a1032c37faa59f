// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/control.hpp>
#include <fretwork/simulation/model_choice.hpp>

#include <map>
#include <memory>
#include <span>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace fretwork::simulation::detail {

/// A tile as its model makes it, and the place of its own axes in the surface.
struct BuiltTile {
    std::shared_ptr<const reduction::TileStructure> structure;
    Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
    Eigen::Vector3d origin = Eigen::Vector3d::Zero();  ///< m
};

/// Options of building tiles.
struct BuildOptions {
    /// Number of threads; 0: one for each processor. Tiles are bitwise the same for every number of threads.
    int threads = 0;
    base::Control control{};
};

/// Builds tiles, and keeps the tiles of models with Sharing::Congruent, so that congruent tiles share them.
///
/// Congruent tiles are recognized by their polygons in their own axes: the origin in the centroid, x along
/// the first side, coordinates rounded to a grid of about a billionth of the mean tile side. A shared tile is
/// built from the rounded polygon, so it does not depend on which tile came first. A polygon that is not
/// convex after the rounding (one with a straight corner, say) is built as it is, and not shared.
///
/// Unused tiles are kept, because an edit may be undone. Once more than kMostUnused tiles have been added
/// since the last cleaning, the next build() drops all unused tiles.
class TileBuilder {
  public:
    struct TilesToBuild {
        const Surface& surface;
        const ModelChoice& choice;
        std::span<const tiling::TileIndex> tiles;
    };
    /// The tiles in their order. Throws as the models do, and as tile_parameters().
    std::vector<BuiltTile> build(const TilesToBuild& wanted, const BuildOptions& options);
    /// All tiles of a surface.
    std::vector<BuiltTile> build_all(const Surface& surface, const ModelChoice& choice,
                                     const BuildOptions& options);

    /// Limit of added tiles. A condensed hexagon takes 10 kB, or 41 kB with two interface nodes a side.
    static constexpr std::size_t kMostUnused = 1000;
    /// The number of kept tiles, used or not.
    [[nodiscard]] std::size_t kept_count() const { return shared_.size(); }

    /// The number of tiles built so far; a shared tile counts once.
    [[nodiscard]] std::size_t built_count() const { return built_count_; }
    /// Forget the shared tiles, because the setting or the calibrations of the surface have changed.
    void forget() { shared_.clear(); }

  private:
    struct Request;
    Request request(const TilesToBuild& wanted, tiling::TileIndex tile, double grid);
    const pattern::Fan& fan_of(const Surface& surface, const tiling::Tile& tile);
    void drop_unused();

    std::map<std::pair<std::string, std::size_t>, pattern::Fan> fans_;  ///< by pattern and number of sides
    std::unordered_map<std::string, std::shared_ptr<const reduction::TileStructure>> shared_;
    std::size_t looked_at_size_ = kMostUnused;  ///< if shared_ is larger, unused tiles are dropped
    std::size_t built_count_ = 0;
};

}  // namespace fretwork::simulation::detail
