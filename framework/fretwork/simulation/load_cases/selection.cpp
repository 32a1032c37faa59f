// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/geometry/internal/place_limits.hpp>
#include <fretwork/geometry/plane.hpp>
#include <fretwork/simulation/load_cases/detail/side_strip.hpp>
#include <fretwork/simulation/load_cases/selection.hpp>

#include <algorithm>
#include <cmath>

namespace fretwork::simulation {
namespace {

using geometry::exact_place_text;
using geometry::Point2;
using tiling::InterfaceIndex;
using tiling::Tessellation;

std::vector<InterfaceIndex> nodes_where(const Tessellation& tessellation, const auto& condition) {
    std::vector<InterfaceIndex> picked;
    for (std::size_t i = 0; i < tessellation.interface_nodes.size(); ++i) {
        if (condition(i)) picked.emplace_back(i);
    }
    return picked;
}

class Picker {
  public:
    explicit Picker(const Tessellation& tessellation) : tessellation_(tessellation) {}

    std::vector<InterfaceIndex> operator()(const NodesById& selection) const {
        std::vector<InterfaceIndex> picked;
        const auto count = static_cast<int>(tessellation_.interface_nodes.size());
        for (const int id : selection.ids) {
            if (id < 0 || id >= count) {
                throw base::InputError("there is no interface node " + std::to_string(id) +
                                       "; they run from 0 to " + std::to_string(count - 1));
            }
            picked.emplace_back(id);
        }
        return picked;
    }

    std::vector<InterfaceIndex> operator()(const NodesInBox& selection) const {
        const auto [xmin, ymin, xmax, ymax] = selection.box;
        auto picked = nodes_where(tessellation_, [&](std::size_t i) {
            const Point2& p = tessellation_.interface_nodes[i];
            return p.x >= xmin && p.x <= xmax && p.y >= ymin && p.y <= ymax;
        });
        if (picked.empty()) {
            throw base::InputError("no interface node lies in the box from " +
                                   exact_place_text({xmin, ymin}) + " to " + exact_place_text({xmax, ymax}));
        }
        return picked;
    }

    std::vector<InterfaceIndex> operator()(const NodesInCircle& selection) const {
        if (!(selection.radius > 0.0) || !std::isfinite(selection.radius))
            throw base::InputError("the radius of the circle is " + base::format_number(selection.radius) +
                                   ", where a length above 0 m is needed");
        const geometry::Circle circle{selection.center, selection.radius};
        auto picked = nodes_where(
            tessellation_, [&](std::size_t i) { return circle.contains(tessellation_.interface_nodes[i]); });
        if (picked.empty()) {
            throw base::InputError("no interface node lies in the circle of radius " +
                                   base::format_number(selection.radius) + " m around " +
                                   exact_place_text(selection.center));
        }
        return picked;
    }

    std::vector<InterfaceIndex> operator()(const NodesNearest& selection) const {
        std::vector<InterfaceIndex> picked;
        for (std::size_t i = 0; i < selection.points.size(); ++i) {
            const Point2& point = selection.points[i];
            if (!geometry::is_within_limits(point))
                throw base::InputError(geometry::beyond_limits_text("point " + std::to_string(i), point));
            const auto nearer = [&](const Point2& a, const Point2& b) {
                return std::hypot(a.x - point.x, a.y - point.y) < std::hypot(b.x - point.x, b.y - point.y);
            };
            const auto& nodes = tessellation_.interface_nodes;
            picked.emplace_back(std::min_element(nodes.begin(), nodes.end(), nearer) - nodes.begin());
        }
        return picked;
    }

    std::vector<InterfaceIndex> operator()(const NodesAtSide& selection) const {
        const detail::SideStrip strip(selection.side, tessellation_);
        std::vector<bool> is_picked(tessellation_.interface_nodes.size(), false);
        for (const auto& line : tiling::rim_sides(tessellation_)) {
            for (const tiling::RimSide& side : line) {
                if (faces_away(side, selection.side)) continue;
                for (const InterfaceIndex node : side.nodes)
                    is_picked[static_cast<std::size_t>(node.value)] =
                        strip.contains(tessellation_.interface_nodes[node]);
            }
        }
        return nodes_where(tessellation_, [&](std::size_t i) { return is_picked[i]; });
    }

  private:
    /// True for the other line of a narrow surface and for the near wall of a hole. The ends of a strip,
    /// which lean a little, are at both of its long sides.
    [[nodiscard]] bool faces_away(const tiling::RimSide& rim, Side side) const {
        constexpr double kMostLean = 0.2;
        const Point2& from = tessellation_.vertices[rim.from];
        const Point2& to = tessellation_.vertices[rim.to];
        return detail::length_along(side, from, to) < -kMostLean * geometry::distance(from, to);
    }

    const Tessellation& tessellation_;
};

}  // namespace

std::vector<InterfaceIndex> select_nodes(const Selection& selection, const Tessellation& tessellation) {
    std::vector<InterfaceIndex> picked = std::visit(Picker(tessellation), selection);
    std::sort(picked.begin(), picked.end());
    picked.erase(std::unique(picked.begin(), picked.end()), picked.end());
    return picked;
}

std::vector<InterfaceIndex> select_some_nodes(const Selection& selection, const Tessellation& tessellation) {
    std::vector<InterfaceIndex> picked = select_nodes(selection, tessellation);
    if (picked.empty()) throw base::InputError("selects no interface node, where one or more are needed");
    return picked;
}

}  // namespace fretwork::simulation
