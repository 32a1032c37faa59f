// SPDX-License-Identifier: GPL-3.0-or-later
// Honeycombs to make, and plans of a few bars.
#pragma once

#include "hexagons.hpp"
#include "support.hpp"

#include <fretwork/base/random.hpp>
#include <fretwork/fabrication/shape.hpp>
#include <fretwork/pattern/enumerate.hpp>
#include <fretwork/simulation/project/project.hpp>

#include <cmath>
#include <numbers>
#include <utility>

namespace fretwork::fabrication::test {

using fretwork::test::complaint_of;
using fretwork::test::TemporaryFolder;
using geometry::Point2;

inline constexpr double kSide = 0.026;   // m
inline constexpr double kWidth = 0.002;  // m
inline constexpr double kPi = std::numbers::pi;

/// Columns of hexagons, painted with patterns by chance.
inline simulation::Surface honeycomb(int columns, int rows, const std::vector<std::string>& patterns,
                                     std::uint64_t seed = 1) {
    fretwork::test::Honeycomb tiles(kSide);
    base::RandomStream random(seed, 0);
    for (int column = 0; column < columns; ++column) {
        for (int row = 0; row < rows; ++row)
            tiles.add(column, row, static_cast<int>(random.uniform() * static_cast<double>(patterns.size())));
    }
    simulation::Project project;
    project.tessellation = std::move(tiles).painted(patterns);
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
