// SPDX-License-Identifier: GPL-3.0-or-later
// Honeycombs to make, and plans of a few bars.
#pragma once

#include "support.hpp"

#include <fretwork/base/random.hpp>
#include <fretwork/fabrication/shape.hpp>
#include <fretwork/pattern/enumerate.hpp>
#include <fretwork/simulation/project/project.hpp>

#include <cmath>
#include <map>
#include <numbers>
#include <utility>

namespace fretwork::fabrication::test {

using fretwork::test::complaint_of;
using fretwork::test::TemporaryFolder;
using geometry::Point2;

inline constexpr double kSide = 0.026;   // m
inline constexpr double kWidth = 0.002;  // m
inline constexpr double kPi = std::numbers::pi;

/// Points that are the same to a tenth of a micrometre are one.
class PointSet {
  public:
    int index(const Point2& point) {
        const auto key = std::pair{std::lround(point.x * 1e7), std::lround(point.y * 1e7)};
        const auto [place, is_new] = indices_.try_emplace(key, static_cast<int>(points.size()));
        if (is_new) points.push_back(point);
        return place->second;
    }
    std::vector<Point2> points;

  private:
    std::map<std::pair<long, long>, int> indices_;
};

inline tiling::Tile add_hexagon(const Point2& center, PointSet& vertices, PointSet& interfaces) {
    const geometry::Polygon hexagon = geometry::regular_polygon(6, kSide);
    tiling::Tile tile;
    for (std::size_t k = 0; k < 6; ++k) {
        const Point2& a = hexagon[k];
        const Point2& b = hexagon[(k + 1) % 6];
        tile.vertices.emplace_back(vertices.index({center.x + a.x, center.y + a.y}));
        tile.interface_nodes.emplace_back(
            interfaces.index({center.x + 0.5 * (a.x + b.x), center.y + 0.5 * (a.y + b.y)}));
    }
    return tile;
}

/// Columns of hexagons, painted with patterns by chance.
inline simulation::Surface honeycomb(int columns, int rows, const std::vector<std::string>& patterns,
                                     std::uint64_t seed = 1) {
    simulation::Project project;
    PointSet vertices;
    PointSet interfaces;
    base::RandomStream random(seed, 0);
    tiling::Tessellation& tessellation = project.tessellation;
    for (int column = 0; column < columns; ++column) {
        for (int row = 0; row < rows; ++row) {
            const Point2 center{1.5 * kSide * column, std::sqrt(3.0) * kSide * (row + 0.5 * (column % 2))};
            tiling::Tile tile = add_hexagon(center, vertices, interfaces);
            tile.pattern = static_cast<int>(random.uniform() * static_cast<double>(patterns.size()));
            tessellation.tiles.push_back(std::move(tile));
        }
    }
    tessellation.layout = "paper7";
    tessellation.vertices = vertices.points;
    tessellation.interface_nodes = interfaces.points;
    tessellation.patterns = pattern::parse_named_patterns(project.layout, patterns);
    return simulation::make_surface(project, nullptr);
}

/// Valid patterns of the paper's layout, evenly spaced among all of them.
inline std::vector<std::string> sample_patterns(std::size_t count) {
    const auto layout = pattern::find_node_layout("paper7");
    const auto all = pattern::enumerate_patterns(layout, {.edges = {2, 11}, .filters = {}});
    std::vector<std::string> ids;
    for (std::size_t i = 0; i < count; ++i) ids.push_back(pattern_id(layout, all[i * all.size() / count]));
    return ids;
}

/// Bars of one width between nodes.
inline BarPlan plan_of(std::vector<Point2> nodes, const std::vector<std::array<int, 2>>& ends) {
    BarPlan plan{.nodes = std::move(nodes), .width = kWidth, .height = 0.003};
    for (const auto& [a, b] : ends)
        plan.bars.push_back({{TessellationNodeIndex(a), TessellationNodeIndex(b)}, kWidth, TileIndex(0)});
    return plan;
}

/// Bars of one length from the origin, at equal angles.
inline BarPlan star(int bars, double length) {
    std::vector<Point2> nodes = {{0.0, 0.0}};
    std::vector<std::array<int, 2>> ends;
    for (int i = 0; i < bars; ++i) {
        const double angle = 0.3 + 2.0 * kPi * i / bars;
        nodes.push_back({length * std::cos(angle), length * std::sin(angle)});
        ends.push_back({0, i + 1});
    }
    return plan_of(std::move(nodes), ends);
}

/// The bars of a plan, each with round ends, and nothing merged.
inline double area_of_bars(const BarPlan& plan) {
    double sum = 0.0;
    for (const Bar& bar : plan.bars) {
        const Point2& a = plan.nodes[bar.nodes[0]];
        const Point2& b = plan.nodes[bar.nodes[1]];
        sum += bar.width * std::hypot(b.x - a.x, b.y - a.y) + 0.25 * kPi * bar.width * bar.width;
    }
    return sum;
}

}  // namespace fretwork::fabrication::test
