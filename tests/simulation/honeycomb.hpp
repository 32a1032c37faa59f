// SPDX-License-Identifier: GPL-3.0-or-later
// Surfaces of regular hexagons, made by hand, so that the tests of the models do not rest on the remeshing.
#pragma once

#include <fretwork/simulation/surface.hpp>

#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace fretwork::test {

/// Collects points; equal ones (to a micrometre) are one.
class PointSet {
  public:
    int add(const geometry::Point2& point) {
        const auto key = std::pair(std::lround(point.x * 1e6), std::lround(point.y * 1e6));
        const auto [place, is_new] = numbers_.emplace(key, static_cast<int>(points.size()));
        if (is_new) points.push_back(point);
        return place->second;
    }
    std::vector<geometry::Point2> points;

  private:
    std::map<std::pair<long, long>, int> numbers_;
};

/// `columns` x `rows` regular hexagons of the paper's size, all painted with the first of `patterns`, the
/// next with the second, and so on. `first_vertex` turns every tile's pattern by so many sectors.
inline simulation::Project honeycomb(int columns, int rows, const std::vector<std::string>& patterns,
                                     int first_vertex = 0) {
    const double side = 0.015 * std::sqrt(3.0);
    const geometry::Polygon hexagon = geometry::regular_polygon(6, side);
    simulation::Project project;
    tiling::Tessellation& tessellation = project.tessellation;
    tessellation.layout = "paper7";
    tessellation.patterns = pattern::parse_named_patterns(project.layout, patterns);
    PointSet vertices;
    PointSet interface_nodes;
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            const double x = 1.5 * side * column;
            const double y = std::sqrt(3.0) * side * (row + 0.5 * (column % 2));
            tiling::Tile tile;
            tile.pattern = static_cast<int>(tessellation.tiles.size() % tessellation.patterns.size());
            for (int k = 0; k < 6; ++k) {
                const geometry::Point2& a = hexagon[static_cast<std::size_t>((k + first_vertex) % 6)];
                const geometry::Point2& b = hexagon[static_cast<std::size_t>((k + first_vertex + 1) % 6)];
                tile.vertices.emplace_back(vertices.add({x + a.x, y + a.y}));
                tile.interface_nodes.emplace_back(
                    interface_nodes.add({x + (a.x + b.x) / 2, y + (a.y + b.y) / 2}));
            }
            tessellation.tiles.push_back(std::move(tile));
        }
    }
    tessellation.vertices = vertices.points;
    tessellation.interface_nodes = interface_nodes.points;
    const double w = 1.5 * side * (columns + 1);
    const double h = std::sqrt(3.0) * side * (rows + 1);
    project.outline = outlines::make_outline({{-w, -h}, {w, -h}, {w, h}, {-w, h}}, {});
    return project;
}

/// Held at the left, pulled at the right.
inline simulation::LoadCase cantilever(const Eigen::Vector3d& total_force) {
    simulation::LoadCase load_case;
    load_case.name = "cantilever";
    load_case.supports.push_back({simulation::NodesAtSide{simulation::Side::Left}, mechanics::DofSet::all()});
    load_case.loads.push_back({simulation::NodesAtSide{simulation::Side::Right}, total_force,
                               Eigen::Vector3d::Zero(), simulation::LoadCase::Amount::Total});
    return load_case;
}

}  // namespace fretwork::test
