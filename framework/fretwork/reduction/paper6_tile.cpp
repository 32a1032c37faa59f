// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/reduction/detail/one_interface_node.hpp>
#include <fretwork/reduction/paper6_problem.hpp>
#include <fretwork/reduction/paper6_tile.hpp>

#include <array>
#include <cmath>
#include <numbers>

namespace fretwork::reduction {
namespace {

using pattern::Point2;

/// Barycentric coordinates (v0, v1, v2) in a sector.
using Place = std::array<double, 3>;

/// The place of a ring node in a sector of a regular polygon: v0 the center, the side's middle straight ahead
/// at the apothem's distance, v1 to the right of it, v2 to the left.
Place ring_place(const Paper6Parameters& parameters, const Setting& setting) {
    const double half_side = setting.tile_side / 2.0;
    const double apothem = half_side / std::tan(std::numbers::pi / setting.sides);
    const double ahead = parameters.R * std::cos(parameters.theta) / apothem;
    const double to_left = parameters.R * std::sin(parameters.theta) / half_side;
    return {1.0 - ahead, (ahead - to_left) / 2.0, (ahead + to_left) / 2.0};
}

Eigen::Vector3d at_place(const Place& place, const std::array<Point2, 3>& sector) {
    Eigen::Vector3d result = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < 3; ++i) result += place[i] * Eigen::Vector3d(sector[i].x, sector[i].y, 0.0);
    return result;
}

using Bounds = TileParameter::Bounds;

/// The bounds of one of the six parameters.
std::function<Bounds(const Setting&)> bounds_of(double Paper6Parameters::*member) {
    return [member](const Setting& setting) {
        const Paper6Bounds bounds = paper6_bounds(setting);
        return Bounds{bounds.lower.*member, bounds.upper.*member};
    };
}

std::vector<TileParameter> parameters() {
    using enum TileParameter::Scale;
    using P = Paper6Parameters;
    return {{"A", "m^2", Logarithmic, bounds_of(&P::A)},    {"I2", "m^4", Logarithmic, bounds_of(&P::I2)},
            {"I3", "m^4", Logarithmic, bounds_of(&P::I3)},  {"J", "m^4", Logarithmic, bounds_of(&P::J)},
            {"theta", "rad", Linear, bounds_of(&P::theta)}, {"R", "m", Linear, bounds_of(&P::R)}};
}

}  // namespace

mechanics::Frame paper6_tile(const Paper6Parameters& parameters, const Setting& setting,
                             const pattern::Polygon& polygon) {
    if (!pattern::is_convex(polygon)) throw base::GeometryError("the polygon of a tile must be convex");
    constexpr Place kMiddleOfSide = {0.0, 0.5, 0.5};
    const Place ring = ring_place(parameters, setting);
    const Point2 center = pattern::centroid(polygon);
    const std::size_t sides = polygon.size();
    mechanics::Frame frame;
    frame.nodes.resize(2 * sides);
    for (std::size_t i = 0; i < sides; ++i) {
        const std::array<Point2, 3> sector = {center, polygon[i], polygon[(i + 1) % sides]};
        frame.nodes[i] = at_place(kMiddleOfSide, sector);
        frame.nodes[sides + i] = at_place(ring, sector);
    }
    const mechanics::Section section{
        .area = parameters.A, .I2 = parameters.I2, .I3 = parameters.I3, .J = parameters.J};
    const auto add_beam = [&](std::size_t from, std::size_t to) {
        frame.beams.push_back({.nodes = {mechanics::NodeIndex(from), mechanics::NodeIndex(to)},
                               .section = section,
                               .material = setting.material});
    };
    for (std::size_t i = 0; i < sides; ++i) add_beam(i, sides + i);
    for (std::size_t i = 0; i < sides; ++i) add_beam(sides + i, sides + (i + 1) % sides);
    return frame;
}

TileModel paper6_tile_model() {
    return {.name = "paper6",
            .summary = "the paper's hexagon with links: six parameters, calibrated; linear",
            .parameters = parameters(),
            .build =
                [](const TileInput& input) {
                    detail::require_one_interface_node(input.layout, "the paper's reduced model is");
                    return beam_tile(paper6_tile(Paper6Parameters::from_values(input.parameters),
                                                 input.setting, input.polygon),
                                     input.fan.interface_node_count);
                },
            .problem =
                [](const Objective& objective, const Setting& setting) {
                    return std::make_unique<Paper6Problem>(std::make_unique<Paper6Hexagon>(setting),
                                                           objective, setting);
                }};
}

}  // namespace fretwork::reduction
