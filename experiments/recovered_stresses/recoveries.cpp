// SPDX-License-Identifier: GPL-3.0-or-later
#include "recoveries.hpp"

#include <fretwork/base/error.hpp>
#include <fretwork/geometry/rotation.hpp>
#include <fretwork/mechanics/linear_element.hpp>
#include <fretwork/mechanics/node_states.hpp>
#include <fretwork/mechanics/paths/equilibrium.hpp>
#include <fretwork/mechanics/results/section_stress.hpp>
#include <fretwork/reduction/models/tile_model.hpp>

#include <Eigen/Geometry>

#include <algorithm>
#include <limits>

namespace fretwork::recovered_stresses {
namespace {

using mechanics::kDofsPerNode;
using mechanics::NodeIndex;
using mechanics::NodeState;
using mechanics::NodeValues;
using simulation::SurfaceResult;
using tiling::TileIndex;

/// A tile alone, in the axes of the surface.
struct LoneTile {
    std::vector<Eigen::Vector3d> places;  ///< of its interface nodes at rest, m
    mechanics::Assembly full;
    mechanics::Assembly corotational;
};

LoneTile lone_tile(const simulation::Surface& surface, TileIndex tile) {
    LoneTile lone;
    for (const auto node : surface.tessellation.tiles[tile].interface_nodes) {
        const auto& place = surface.tessellation.interface_nodes[node];
        lone.places.emplace_back(place.x, place.y, 0.0);
    }
    const geometry::Polygon polygon = tiling::tile_polygon(surface.tessellation, tile);
    const pattern::Fan fan =
        pattern::make_fan(surface.layout, tiling::pattern_of(surface.tessellation, tile)->pattern,
                          static_cast<int>(polygon.size()));
    const auto assembled = [&](const char* model) {
        const auto structure =
            reduction::build_tile(reduction::find_tile_model(model),
                                  {surface.layout, fan, surface.setting, polygon, std::span<const double>{}});
        return reduction::assemble(reduction::tile_parts(*structure, lone.places));
    };
    lone.full = assembled("full");
    // The corotational model is built in any axes; here, in those of the surface.
    lone.corotational = assembled("corotational");
    return lone;
}

/// The states without the mean turn of the nodes, and their mean displacement.
std::vector<NodeState> without_mean_motion(std::span<const Eigen::Vector3d> places,
                                           std::span<const NodeState> states) {
    Eigen::Vector4d turns = Eigen::Vector4d::Zero();
    Eigen::Vector3d rest = Eigen::Vector3d::Zero();
    Eigen::Vector3d moved = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < states.size(); ++i) {
        const Eigen::Vector4d turn = states[i].rotation.coeffs();
        turns += turn.dot(states[0].rotation.coeffs()) < 0.0 ? Eigen::Vector4d(-turn) : turn;
        rest += places[i] / static_cast<double>(states.size());
        moved += (places[i] + states[i].displacement) / static_cast<double>(states.size());
    }
    const Eigen::Quaterniond back = Eigen::Quaterniond(turns).normalized().conjugate();
    std::vector<NodeState> local(states.size());
    for (std::size_t i = 0; i < states.size(); ++i) {
        local[i].displacement = back * (places[i] + states[i].displacement - moved) - (places[i] - rest);
        local[i].rotation = back * states[i].rotation;
    }
    return local;
}

void hold(NodeIndex node, const NodeState& state, mechanics::Assembly& assembly) {
    assembly.supports.push_back({node, mechanics::DofSet::all()});
    const Eigen::Vector3d rotation = geometry::logarithm(state.rotation);
    for (int d = 0; d < 3; ++d) {
        assembly.prescribed.push_back({node, static_cast<mechanics::Dof>(d), state.displacement[d]});
        assembly.prescribed.push_back({node, static_cast<mechanics::Dof>(d + 3), rotation[d]});
    }
}

/// The forces and moments on the interface nodes that keep the corotational tile in these states.
void load(const mechanics::Assembly& corotational, std::span<const NodeState> states,
          mechanics::Assembly& assembly) {
    mechanics::ElementResponse response;
    corotational.elements.at(0)->evaluate(states, mechanics::Demand::Force, response);
    for (std::size_t i = 0; i < states.size(); ++i)
        assembly.loads.row(static_cast<Eigen::Index>(i)) +=
            response.force.segment<kDofsPerNode>(static_cast<Eigen::Index>(i) * kDofsPerNode).transpose();
    assembly.has_moments = true;
}

/// Springs that are without force in these states.
void put_on_springs(const mechanics::Assembly& corotational, std::span<const NodeState> states,
                    double stiffness, mechanics::Assembly& assembly) {
    Eigen::MatrixXd own;
    corotational.elements.at(0)->rest_stiffness(own);
    mechanics::ElementResponse response;
    for (std::size_t i = 0; i < states.size(); ++i) {
        const auto row = static_cast<Eigen::Index>(i);
        Eigen::MatrixXd block =
            stiffness * own.block<kDofsPerNode, kDofsPerNode>(row * kDofsPerNode, row * kDofsPerNode);
        assembly.elements.push_back(mechanics::linear_element({NodeIndex(i)}, {std::move(block)}));
        assembly.elements.back()->evaluate(states.subspan(i, 1), mechanics::Demand::Force, response);
        assembly.loads.row(row) += response.force.transpose();
    }
}

/// The row of a node of the surface among those of its tile.
Eigen::Index row_of(const simulation::Surface& surface, const simulation::SurfaceBeams& beams, TileIndex tile,
                    NodeIndex node) {
    const auto& own = surface.tessellation.tiles[tile].interface_nodes;
    const std::size_t n = node;
    if (n >= beams.interface_nodes)
        return static_cast<Eigen::Index>(own.size() + n - beams.starts[tile].inner_node);
    const auto is_node = [&](tiling::InterfaceIndex interface) { return interface.value == node.value; };
    return std::ranges::find_if(own, is_node) - own.begin();
}

}  // namespace

Recoveries::Recoveries(const simulation::Session& session)
    : session_(session),
      beams_(simulation::surface_beams(session.surface())),
      sections_(simulation::beam_sections(beams_, session.surface().setting)) {}

void Recoveries::write(TileIndex tile, const NodeValues& rows, Answer answer, Stresses& stresses) const {
    const mechanics::SectionPoints bar(session_.surface().setting.section);
    for (std::size_t b = beams_.starts[tile].beam;
         b < beams_.starts[static_cast<std::size_t>(tile.value) + 1].beam; ++b) {
        const auto from = rows.row(row_of(session_.surface(), beams_, tile, beams_.ends[b][0]));
        const auto to = rows.row(row_of(session_.surface(), beams_, tile, beams_.ends[b][1]));
        const auto ends = answer == Answer::Large
                              ? sections_[b].large(mechanics::node_state(from), mechanics::node_state(to))
                              : sections_[b].linear(from.transpose(), to.transpose());
        stresses[static_cast<Eigen::Index>(b)] =
            std::max(bar.largest(ends[0]).von_mises, bar.largest(ends[1]).von_mises);
    }
}

Stresses Recoveries::built_in(const SurfaceResult& result) const {
    const simulation::BeamState state = simulation::beam_state(session_, result.solution, beams_, sections_);
    Stresses stresses(std::ssize(beams_.ends));
    for (Eigen::Index b = 0; b < stresses.size(); ++b)
        stresses[b] = state.forces.col(simulation::kVonMisesField).segment<2>(2 * b).maxCoeff();
    return stresses;
}

Stresses Recoveries::following(const SurfaceResult& result, Answer answer) const {
    Stresses stresses(std::ssize(beams_.ends));
    for (const TileIndex tile : session_.surface().tessellation.tiles.indices()) {
        const auto motion = session_.beam_motion(tile, result.solution);
        if (!motion) throw base::NumericalError("a tile has no frame");
        write(tile, motion->in_axes, answer, stresses);
    }
    return stresses;
}

Stresses Recoveries::linear(const SurfaceResult& result) const {
    return following(result, Answer::Linear);
}
Stresses Recoveries::large_beams(const SurfaceResult& result) const {
    return following(result, Answer::Large);
}

Stresses Recoveries::alone(const SurfaceResult& result, Boundary boundary) const {
    const auto& tiles = session_.surface().tessellation.tiles;
    const std::vector<NodeState> states = mechanics::node_states(result.solution.displacements);
    Stresses stresses(std::ssize(beams_.ends));
    for (const TileIndex tile : tiles.indices()) {
        LoneTile lone = lone_tile(session_.surface(), tile);
        std::vector<NodeState> own;
        for (const auto node : tiles[tile].interface_nodes) own.push_back(states[node]);
        const std::vector<NodeState> local = without_mean_motion(lone.places, own);
        if (boundary.is_loaded) load(lone.corotational, local, lone.full);
        if (boundary.spring_stiffness > 0.0)
            put_on_springs(lone.corotational, local, boundary.spring_stiffness, lone.full);
        for (std::size_t i = 0; i < std::min(boundary.held, local.size()); ++i)
            hold(NodeIndex(i), local[i], lone.full);
        const mechanics::Solution solution = mechanics::follow_load_path(lone.full, std::vector{1.0}).back();
        if (!solution.converged())
            throw base::NumericalError("tile " + std::to_string(tile.value) +
                                       " alone has no equilibrium that was found");
        write(tile, solution.displacements, Answer::Large, stresses);
    }
    return stresses;
}

Stresses Recoveries::held_tiles(const SurfaceResult& result) const {
    return alone(result, {.held = std::numeric_limits<std::size_t>::max()});
}
Stresses Recoveries::loaded_tiles(const SurfaceResult& result) const {
    return alone(result, {.held = 1, .is_loaded = true});
}
Stresses Recoveries::sprung_tiles(const SurfaceResult& result, double stiffness) const {
    return alone(result, {.is_loaded = true, .spring_stiffness = stiffness});
}

}  // namespace fretwork::recovered_stresses
