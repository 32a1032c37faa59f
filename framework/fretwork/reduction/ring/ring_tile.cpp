// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/geometry/nearly_convex.hpp>
#include <fretwork/reduction/ring/ring_problem.hpp>
#include <fretwork/reduction/ring/ring_tile.hpp>

#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace fretwork::reduction {
namespace {

using geometry::Point2;

/// Barycentric coordinates (v0, v1, v2) in a sector.
using Place = std::array<double, 3>;

/// The places of the interface nodes of a side.
std::vector<Place> interface_places(const pattern::NodeLayout& layout) {
    std::vector<Place> places;
    for (const pattern::LayoutNodeIndex node : layout.interface_nodes()) {
        const auto& exact = layout.nodes()[node].place;
        places.push_back({exact[0].to_double(), exact[1].to_double(), exact[2].to_double()});
    }
    return places;
}

/// The place of the ring node that belongs to an interface node, in a sector of a regular polygon. Seen from
/// the center v0, the middle of the side lies straight ahead at the distance of the apothem, v1 to the right
/// of it, and v2 to the left.
Place ring_place(const Place& interface, const RingParts& parts, const Setting& setting) {
    const double theta = parts[kRingTheta];
    const double R = parts[kRingR];
    const double half_side = setting.tile_side / 2.0;
    const double apothem = half_side / std::tan(std::numbers::pi / setting.sides);
    const double beside = R * (interface[2] - interface[1]) * half_side / apothem;
    const double ahead = (R * std::cos(theta) - beside * std::sin(theta)) / apothem;
    const double to_left = (R * std::sin(theta) + beside * std::cos(theta)) / half_side;
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

/// The parameters of the tile model's row.
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

mechanics::Frame ring_tile(const RingParts& parts, const pattern::NodeLayout& layout, const Setting& setting,
                           const geometry::Polygon& polygon) {
    if (!geometry::is_nearly_convex(polygon))
        throw base::GeometryError("the polygon of a tile must be convex");
    const std::vector<Place> of_side = interface_places(layout);
    const Point2 center = geometry::centroid(polygon);
    const std::size_t count = polygon.size() * of_side.size();
    mechanics::Frame frame;
    frame.nodes.resize(2 * count);
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t side = i / of_side.size();
        const Place& own = of_side[i % of_side.size()];
        const std::array<Point2, 3> sector = {center, polygon[side], polygon[(side + 1) % polygon.size()]};
        frame.nodes[i] = at_place(own, sector);
        frame.nodes[count + i] = at_place(ring_place(own, parts, setting), sector);
    }
    const auto add_beam = [&](std::size_t from, std::size_t to, const mechanics::Section& section) {
        frame.beams.push_back({.nodes = {mechanics::NodeIndex(from), mechanics::NodeIndex(to)},
                               .section = section,
                               .material = setting.material});
    };
    const auto links = section_of(parts.head<4>());
    const auto ring_beams = section_of(parts.segment<4>(4));
    for (std::size_t i = 0; i < count; ++i) add_beam(i, count + i, links);
    for (std::size_t i = 0; i < count; ++i) add_beam(count + i, count + (i + 1) % count, ring_beams);
    return frame;
}

TileModel ring_tile_model(base::Borrowed<RingParameters> parameters, std::string summary) {
    return {.name = parameters->model,
            .summary = std::move(summary),
            .parameters = tile_parameters(parameters),
            .build =
                [parameters](const TileInput& input) {
                    return beam_tile(ring_tile(parameters->parts(input.parameters), input.layout,
                                               input.setting, input.polygon),
                                     input.fan->interface_node_count);
                },
            .problem = [parameters](const Objective& objective, const pattern::NodeLayout& layout,
                                    const Setting& setting) -> std::unique_ptr<CalibrationProblem> {
                if (!RingHexagon::fits(layout, setting)) return nullptr;
                return std::make_unique<RingProblem>(std::make_unique<RingHexagon>(setting), parameters,
                                                     objective, setting);
            }};
}

}  // namespace fretwork::reduction
