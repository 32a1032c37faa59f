// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/reduction/detail/one_interface_node.hpp>
#include <fretwork/reduction/ring_problem.hpp>
#include <fretwork/reduction/ring_tile.hpp>

#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace fretwork::reduction {
namespace {

using pattern::Point2;

/// Barycentric coordinates (v0, v1, v2) in a sector.
using Place = std::array<double, 3>;

/// The place of a ring node in a sector of a regular polygon: v0 the center, the side's middle straight ahead
/// at the apothem's distance, v1 to the right of it, v2 to the left.
Place ring_place(double theta, double R, const Setting& setting) {
    const double half_side = setting.tile_side / 2.0;
    const double apothem = half_side / std::tan(std::numbers::pi / setting.sides);
    const double ahead = R * std::cos(theta) / apothem;
    const double to_left = R * std::sin(theta) / half_side;
    return {1.0 - ahead, (ahead - to_left) / 2.0, (ahead + to_left) / 2.0};
}

Eigen::Vector3d at_place(const Place& place, const std::array<Point2, 3>& sector) {
    Eigen::Vector3d result = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < 3; ++i) result += place[i] * Eigen::Vector3d(sector[i].x, sector[i].y, 0.0);
    return result;
}

mechanics::Section section_of(const Eigen::Vector4d& parts) {
    return {.area = parts[0], .I2 = parts[1], .I3 = parts[2], .J = parts[3]};
}

/// The rows of the table of parameters.
std::vector<TileParameter> tile_parameters(const RingParameters& parameters) {
    constexpr std::array<const char*, kRingParts> kUnits = {"m^2", "m^4", "m^4", "m^4", "m^2",
                                                            "m^4", "m^4", "m^4", "rad", "m"};
    std::vector<TileParameter> rows;
    for (std::size_t k = 0; k < parameters.names.size(); ++k) {
        const Eigen::Index part = parameters.part_of(static_cast<Eigen::Index>(k));
        rows.push_back({parameters.names[k], kUnits[static_cast<std::size_t>(part)],
                        part < kRingTheta ? TileParameter::Scale::Logarithmic : TileParameter::Scale::Linear,
                        [part](const Setting& setting) {
                            const RingBounds bounds = ring_bounds(setting);
                            return TileParameter::Bounds{bounds.lower[part], bounds.upper[part]};
                        }});
    }
    return rows;
}

}  // namespace

mechanics::Frame ring_tile(const RingParts& parts, const Setting& setting, const pattern::Polygon& polygon) {
    if (!pattern::is_convex(polygon)) throw base::GeometryError("the polygon of a tile must be convex");
    constexpr Place kMiddleOfSide = {0.0, 0.5, 0.5};
    const Place ring = ring_place(parts[kRingTheta], parts[kRingR], setting);
    const Point2 center = pattern::centroid(polygon);
    const std::size_t sides = polygon.size();
    mechanics::Frame frame;
    frame.nodes.resize(2 * sides);
    for (std::size_t i = 0; i < sides; ++i) {
        const std::array<Point2, 3> sector = {center, polygon[i], polygon[(i + 1) % sides]};
        frame.nodes[i] = at_place(kMiddleOfSide, sector);
        frame.nodes[sides + i] = at_place(ring, sector);
    }
    const auto add_beam = [&](std::size_t from, std::size_t to, const mechanics::Section& section) {
        frame.beams.push_back({.nodes = {mechanics::NodeIndex(from), mechanics::NodeIndex(to)},
                               .section = section,
                               .material = setting.material});
    };
    const auto links = section_of(parts.head<4>());
    const auto ring_beams = section_of(parts.segment<4>(4));
    for (std::size_t i = 0; i < sides; ++i) add_beam(i, sides + i, links);
    for (std::size_t i = 0; i < sides; ++i) add_beam(sides + i, sides + (i + 1) % sides, ring_beams);
    return frame;
}

TileModel ring_tile_model(const RingParameters& parameters, std::string summary) {
    return {.name = parameters.model,
            .summary = std::move(summary),
            .parameters = tile_parameters(parameters),
            .build =
                [&parameters](const TileInput& input) {
                    detail::require_one_interface_node(input.layout,
                                                       "the tile model " + parameters.model + " is");
                    return beam_tile(
                        ring_tile(parameters.parts(input.parameters), input.setting, input.polygon),
                        input.fan.interface_node_count);
                },
            .problem =
                [&parameters](const Objective& objective, const Setting& setting) {
                    return std::make_unique<RingProblem>(std::make_unique<RingHexagon>(setting), parameters,
                                                         objective, setting);
                }};
}

}  // namespace fretwork::reduction
