// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/parallel.hpp>
#include <fretwork/geometry/rotation.hpp>
#include <fretwork/mechanics/node_states.hpp>
#include <fretwork/mechanics/paths/equilibrium.hpp>
#include <fretwork/simulation/detail/tile_builder.hpp>
#include <fretwork/simulation/results/tile_stability.hpp>

#include <Eigen/Geometry>

namespace fretwork::simulation {
namespace {

using mechanics::NodeIndex;
using mechanics::NodeState;

/// The nodes' states without the mean turn and the mean displacement, which cause no strain.
std::vector<NodeState> local_states(std::span<const Eigen::Vector3d> places,
                                    std::span<const NodeState> states) {
    Eigen::Vector4d mean_turn = Eigen::Vector4d::Zero();
    Eigen::Vector3d rest_mean = Eigen::Vector3d::Zero();
    Eigen::Vector3d moved_mean = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < states.size(); ++i) {
        const Eigen::Vector4d turn = states[i].rotation.coeffs();
        mean_turn += turn.dot(states[0].rotation.coeffs()) < 0.0 ? Eigen::Vector4d(-turn) : turn;
        rest_mean += places[i] / static_cast<double>(states.size());
        moved_mean += (places[i] + states[i].displacement) / static_cast<double>(states.size());
    }
    const Eigen::Quaterniond back = Eigen::Quaterniond(mean_turn).normalized().conjugate();
    std::vector<NodeState> local(states.size());
    for (std::size_t i = 0; i < states.size(); ++i) {
        const Eigen::Vector3d arm = places[i] - rest_mean;
        local[i].displacement = back * (places[i] + states[i].displacement - moved_mean) - arm;
        local[i].rotation = back * states[i].rotation;
    }
    return local;
}

/// The tile alone, its interface nodes held in these states.
mechanics::Assembly held_tile(const reduction::TileStructure& tile, std::span<const Eigen::Vector3d> places,
                              std::span<const NodeState> states) {
    mechanics::Assembly assembly = reduction::assemble(reduction::tile_parts(tile, places));
    for (std::size_t i = 0; i < states.size(); ++i) {
        assembly.supports.push_back({NodeIndex(i), mechanics::DofSet::all()});
        const Eigen::Vector3d rotation = geometry::logarithm(states[i].rotation);
        for (int d = 0; d < 3; ++d) {
            const auto dof = static_cast<std::size_t>(d);
            assembly.prescribed.push_back(
                {NodeIndex(i), static_cast<mechanics::Dof>(dof), states[i].displacement[d]});
            assembly.prescribed.push_back({NodeIndex(i), static_cast<mechanics::Dof>(dof + 3), rotation[d]});
        }
    }
    return assembly;
}

bool buckles(const mechanics::Assembly& tile, const base::Control& control) {
    const mechanics::Solution solution =
        mechanics::follow_load_path(tile, std::vector{1.0}, {.control = {.stop = control.stop}}).back();
    return !solution.is_stable_equilibrium();
}

}  // namespace

std::vector<tiling::TileIndex> buckled_tiles(const Surface& surface, const mechanics::Solution& solution,
                                             const SimulationOptions& options, const base::Control& control) {
    Surface full = surface;
    full.tile_models.clear();
    detail::TileBuilder builder;
    const auto built = builder.build_all(full, reference_choice(options), {options.threads, control});
    const std::vector<NodeState> states = mechanics::node_states(solution.displacements);
    std::vector<char> is_buckled(built.size(), 0);
    base::parallel_for(built.size(), options.threads, [&](std::size_t t) {
        control.check();
        std::vector<Eigen::Vector3d> places;
        std::vector<NodeState> own;
        for (const tiling::InterfaceIndex node : surface.tessellation.tiles[t].interface_nodes) {
            const auto& place = surface.tessellation.interface_nodes[node];
            places.emplace_back(place.x, place.y, 0.0);
            own.push_back(states[node]);
        }
        if (buckles(held_tile(*built[t].structure, places, local_states(places, own)), control))
            is_buckled[t] = 1;
    });
    std::vector<tiling::TileIndex> buckled;
    for (std::size_t t = 0; t < is_buckled.size(); ++t) {
        if (is_buckled[t] != 0) buckled.emplace_back(t);
    }
    return buckled;
}

}  // namespace fretwork::simulation
