// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/parallel.hpp>
#include <fretwork/mechanics/corotational_element.hpp>
#include <fretwork/simulation/detail/session_impl.hpp>

namespace fretwork::simulation {

using tiling::TileIndex;

/// A tile with a corotational body is one element. Only such a tile has strains.
TileLinearization Session::Impl::linearized_tile(TileIndex tile,
                                                 const mechanics::EquilibriumTangent& tangent) const {
    const std::size_t t = tile;
    TileLinearization result;
    result.nodes = surface_.tessellation.tiles[tile].interface_nodes;
    result.mass = acting_mass(tile);
    const mechanics::CorotationalBody* body = tiles_[t].structure->corotational_body();
    if (body == nullptr) return result;
    const std::size_t element = detail::first_element(assembly_, starts_, tile);
    std::vector<mechanics::NodeState> states;
    for (const tiling::InterfaceIndex node : result.nodes) states.push_back(tangent.states()[node]);
    const auto moved = mechanics::corotational_motion(*body, tiles_[t].turn, states);
    if (!moved) return result;
    result.strains = moved->in_axes.transpose().reshaped();
    result.slopes = tangent.strain_slopes(element);
    result.forces = tangent.internal_forces(element);
    result.energy = 0.5 * result.strains.dot(body->stiffness() * result.strains);
    return result;
}

Linearization Session::Impl::linearize(TileQuantities quantities, const base::Control& control) {
    if (!is_at_equilibrium_ || solved_in_ != reduction::Displacements::Large)
        throw base::InputError(
            "there is no nonlinear equilibrium to take derivatives at: it is found by a solution in one load "
            "step, after "
            "the last edit, of a model for large displacements");
    Linearization result{.tangent = equilibrium_solver_->tangent(control),
                         .reported_nodes = assembly_.reported_nodes,
                         .tiles = {},
                         .loads = assembly_.loads,
                         .gravity = load_case_.gravity};
    result.tiles.resize(tiles_.size());
    base::parallel_for(tiles_.size(), options_.threads, [&](std::size_t t) {
        control.check();
        result.tiles[t] = linearized_tile(TileIndex(t), result.tangent);
    });
    if (quantities == TileQuantities::Strains) return result;
    std::vector<std::size_t> elements;
    std::vector<std::size_t> owners;
    for (std::size_t t = 0; t < tiles_.size(); ++t) {
        if (result.tiles[t].strains.size() == 0) continue;
        owners.push_back(t);
        elements.push_back(detail::first_element(assembly_, starts_, TileIndex(t)));
    }
    const std::vector<Eigen::MatrixXd> blocks = result.tangent.flexibilities(elements, control);
    for (std::size_t i = 0; i < owners.size(); ++i) {
        TileLinearization& tile = result.tiles[owners[i]];
        tile.flexibility = tile.slopes * blocks[i] * tile.slopes.transpose();
    }
    return result;
}

}  // namespace fretwork::simulation
