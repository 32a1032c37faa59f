// SPDX-License-Identifier: GPL-3.0-or-later
// A honeycomb with made-up displacements to draw and to write.
#pragma once

#include "support.hpp"

#include <fretwork/exports/writer_catalogue.hpp>

#include <cmath>
#include <map>
#include <utility>

namespace fretwork::exports::test {

using fretwork::test::complaint_of;
using fretwork::test::TemporaryFolder;

inline constexpr double kSide = 0.026;

/// Points that are the same to a tenth of a micrometre are one.
class PointSet {
  public:
    int index(const geometry::Point2& point) {
        const auto key = std::pair{std::lround(point.x * 1e7), std::lround(point.y * 1e7)};
        const auto [place, is_new] = indices_.try_emplace(key, static_cast<int>(points_.size()));
        if (is_new) points_.push_back(point);
        return place->second;
    }
    [[nodiscard]] const std::vector<geometry::Point2>& points() const { return points_; }

  private:
    std::map<std::pair<long, long>, int> indices_;
    std::vector<geometry::Point2> points_;
};

/// A honeycomb of the paper's layout, tile t painted with pattern t modulo their number.
inline tiling::Tessellation honeycomb(int columns, int rows, std::vector<std::string> patterns) {
    tiling::Tessellation tessellation;
    PointSet vertices;
    PointSet interfaces;
    const geometry::Polygon hexagon = geometry::regular_polygon(6, kSide);
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            const double x = 1.5 * kSide * column;
            const double y = std::sqrt(3.0) * kSide * (row + 0.5 * (column % 2));
            tiling::Tile tile;
            for (std::size_t k = 0; k < hexagon.size(); ++k) {
                const auto& a = hexagon[k];
                const auto& b = hexagon[(k + 1) % hexagon.size()];
                tile.vertices.emplace_back(vertices.index({x + a.x, y + a.y}));
                tile.interface_nodes.emplace_back(
                    interfaces.index({x + 0.5 * (a.x + b.x), y + 0.5 * (a.y + b.y)}));
            }
            tile.pattern = static_cast<int>(tessellation.tiles.size() % patterns.size());
            tessellation.tiles.push_back(tile);
        }
    }
    tessellation.layout = "paper7";
    tessellation.vertices = vertices.points();
    tessellation.interface_nodes = interfaces.points();
    tessellation.patterns = pattern::parse_named_patterns(pattern::find_node_layout("paper7"), patterns);
    return tessellation;
}

inline simulation::Surface sample_surface(int columns = 3, int rows = 2) {
    simulation::Project project;
    project.tessellation = honeycomb(columns, rows, {"0-1+1-6", "1-6+3-6", "0-1+0-6+1-6"});
    return simulation::make_surface(project, nullptr);
}

/// The surface bent upwards from x = 0 on, `share` of the way: of every node (the full model), or of the
/// interface nodes only (a reduced one).
enum class Rows { EveryNode, InterfaceNodes };
inline simulation::SurfaceResult bent(const simulation::Surface& surface, Rows rows, double share = 1.0) {
    const std::size_t interfaces = surface.tessellation.interface_nodes.size();
    const tiling::TessellationFan fan = simulation::surface_fan(surface);
    const std::size_t count = rows == Rows::EveryNode ? fan.nodes.size() : interfaces;
    double xmax = 0.0;
    for (const auto& node : fan.nodes) xmax = std::max(xmax, node.x);
    simulation::SurfaceResult result;
    result.solver = "made up";
    result.solution.displacements = mechanics::NodeValues::Zero(static_cast<Eigen::Index>(count), 6);
    for (std::size_t i = 0; i < count; ++i) {
        const auto& node = fan.nodes[i];
        result.nodes.push_back({static_cast<int>(i), {node.x, node.y, 0.0}, i < interfaces});
        const double angle = 0.9 * share * node.x / xmax;
        const double radius = xmax / (0.9 * share);
        result.solution.displacements.row(static_cast<Eigen::Index>(i)) << radius * std::sin(angle) - node.x,
            0.0, radius * (1.0 - std::cos(angle)), 0.0, -angle, 0.0;
    }
    return result;
}

inline simulation::Conditions sample_conditions(const simulation::Surface& surface) {
    simulation::Conditions conditions;
    const auto& nodes = surface.tessellation.interface_nodes;
    double xmax = 0.0;
    for (const auto& node : nodes) xmax = std::max(xmax, node.x);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const mechanics::NodeIndex index(i);
        if (nodes[i].x < 0.0) {
            conditions.supports.push_back({index, nodes[i].y < 2 * kSide
                                                      ? mechanics::DofSet::all()
                                                      : mechanics::DofSet::translations()});
        }
        if (nodes[i].x > xmax - 0.6 * kSide) {
            mechanics::NodalLoad load{index};
            load.force = {0.0, 0.4, 1.0};
            conditions.loads.push_back(load);
        }
    }
    return conditions;
}

}  // namespace fretwork::exports::test
