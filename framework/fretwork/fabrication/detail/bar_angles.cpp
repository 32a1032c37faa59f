// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/fabrication/detail/bar_angles.hpp>
#include <fretwork/geometry/plane.hpp>

#include <map>
#include <numbers>
#include <tuple>

namespace fretwork::fabrication::detail {

using geometry::Point2;

std::vector<BarAngle> bar_angles(const BarPlan& plan) {
    struct Direction {
        double angle;
        TileIndex tile;
    };
    std::map<int, std::vector<Direction>> directions;
    for (const Bar& bar : plan.bars) {
        const Point2 along = plan.nodes[bar.nodes[1]] - plan.nodes[bar.nodes[0]];
        directions[bar.nodes[0]].push_back({std::atan2(along.y, along.x), bar.tile});
        directions[bar.nodes[1]].push_back({std::atan2(-along.y, -along.x), bar.tile});
    }
    std::vector<BarAngle> angles;
    for (auto& [node, around] : directions) {
        if (around.size() < 2) continue;
        std::ranges::sort(around, {}, &Direction::angle);
        BarAngle smallest{around.front().angle + 2.0 * std::numbers::pi - around.back().angle,
                          TessellationNodeIndex(node), around.front().tile};
        for (std::size_t i = 0; i + 1 < around.size(); ++i) {
            const double angle = around[i + 1].angle - around[i].angle;
            if (angle < smallest.angle) smallest = {angle, TessellationNodeIndex(node), around[i].tile};
        }
        angles.push_back(smallest);
    }
    std::ranges::sort(angles, {},
                      [](const BarAngle& one) { return std::tuple(one.angle, static_cast<int>(one.node)); });
    return angles;
}

}  // namespace fretwork::fabrication::detail
