// SPDX-License-Identifier: GPL-3.0-or-later
// Tessellations of regular hexagons, made by hand, so that tests of what lies on tiles do not depend on the
// remeshing.
#pragma once

#include <fretwork/geometry/point_grid.hpp>
#include <fretwork/tiling/tessellation.hpp>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace fretwork::test {

/// A tessellation of the paper's layout, made of regular hexagons tile by tile.
class Honeycomb {
  public:
    /// @param side  side of the hexagons, m
    explicit Honeycomb(double side) : side_(side), hexagon_(geometry::regular_polygon(6, side)) {}

    /// The number of tiles so far.
    [[nodiscard]] std::size_t size() const { return tessellation_.tiles.size(); }
    /// Add a tile; odd columns lie half a tile higher. Vertex 0 of the tile is this vertex of the hexagon.
    void add(int column, int row, int pattern, int first_vertex = 0) {
        const double x = 1.5 * side_ * column;
        const double y = std::sqrt(3.0) * side_ * (row + 0.5 * (column % 2));
        tiling::Tile tile;
        tile.pattern = pattern;
        for (int k = 0; k < 6; ++k) {
            const geometry::Point2& a = hexagon_[static_cast<std::size_t>((k + first_vertex) % 6)];
            const geometry::Point2& b = hexagon_[static_cast<std::size_t>((k + first_vertex + 1) % 6)];
            tile.vertices.emplace_back(vertices_.number_of({x + a.x, y + a.y}, kSame));
            tile.interface_nodes.emplace_back(
                interface_nodes_.number_of({x + (a.x + b.x) / 2, y + (a.y + b.y) / 2}, kSame));
        }
        tessellation_.tiles.push_back(std::move(tile));
    }
    /// The tessellation of all tiles added, with the patterns of these ids.
    [[nodiscard]] tiling::Tessellation painted(const std::vector<std::string>& patterns) && {
        tessellation_.layout = "paper7";
        tessellation_.patterns = pattern::parse_named_patterns(pattern::paper_layout(), patterns);
        tessellation_.vertices = vertices_.points();
        tessellation_.interface_nodes = interface_nodes_.points();
        return std::move(tessellation_);
    }

  private:
    static constexpr double kSame = 1e-6;  // m
    double side_;
    geometry::Polygon hexagon_;
    geometry::PointGrid vertices_{kSame};
    geometry::PointGrid interface_nodes_{kSame};
    tiling::Tessellation tessellation_;
};

/// `columns` x `rows` hexagons, row by row, tile t painted with pattern t modulo their number. `first_vertex`
/// turns every tile's pattern by this number of sectors.
inline tiling::Tessellation hexagons(double side, int columns, int rows,
                                     const std::vector<std::string>& patterns, int first_vertex = 0) {
    Honeycomb tiles(side);
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column)
            tiles.add(column, row, static_cast<int>(tiles.size() % patterns.size()), first_vertex);
    }
    return std::move(tiles).painted(patterns);
}

}  // namespace fretwork::test
