// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/geometry/rotation.hpp>
#include <fretwork/mechanics/node_states.hpp>
#include <fretwork/simulation/detail/session_impl.hpp>
#include <fretwork/simulation/detail/tile_sensitivity.hpp>

#include <utility>

namespace fretwork::simulation {
namespace {

using mechanics::kDofsPerNode;
using mechanics::NodeValues;
using tiling::TileIndex;

/// The rows of some nodes, one behind the other.
Eigen::VectorXd rows_at(const NodeValues& rows, std::span<const mechanics::NodeIndex> nodes) {
    Eigen::VectorXd own(kDofsPerNode * std::ssize(nodes));
    Eigen::Index next = 0;
    for (const mechanics::NodeIndex node : nodes) {
        own.segment<kDofsPerNode>(next) = rows.row(node.value).transpose();
        next += kDofsPerNode;
    }
    return own;
}

void add_at(std::span<const mechanics::NodeIndex> nodes, const Eigen::VectorXd& own, NodeValues& rows) {
    Eigen::Index next = 0;
    for (const mechanics::NodeIndex node : nodes) {
        rows.row(node.value) += own.segment<kDofsPerNode>(next).transpose();
        next += kDofsPerNode;
    }
}

/// Turn displacements and rotation vectors from the surface's axes into a tile's own axes. `turn` leads from
/// the own axes to the surface's.
Eigen::VectorXd turned_back(Eigen::VectorXd rows, const Eigen::Matrix3d& turn) {
    for (Eigen::Index i = 0; i < rows.size(); i += 3)
        rows.segment<3>(i) = (turn.transpose() * rows.segment<3>(i)).eval();
    return rows;
}

}  // namespace

NodeValues Session::Impl::all_rows(const mechanics::Solution& solution) {
    NodeValues rows(solution.displacements.rows() + solution.inner_displacements.rows(), kDofsPerNode);
    rows << solution.displacements, solution.inner_displacements;
    return rows;
}

/// The internal forces K u of linear motions u.
NodeValues Session::Impl::rest_forces(const NodeValues& motions) const {
    NodeValues forces = NodeValues::Zero(motions.rows(), kDofsPerNode);
    Eigen::MatrixXd stiffness;
    for (const auto& element : assembly_.elements) {
        element->rest_stiffness(stiffness);
        add_at(element->nodes(), stiffness * rows_at(motions, element->nodes()), forces);
    }
    return forces;
}

NodeValues Session::Impl::energy_gradient(const mechanics::Solution& solution) const {
    require_since_edit(solution);
    const NodeValues rows = all_rows(solution);
    if (solved_in_ == reduction::Displacements::Small)
        return rest_forces(rows).topRows(assembly_.reported_nodes);
    const std::vector<mechanics::NodeState> states = mechanics::node_states(rows);
    NodeValues gradient = NodeValues::Zero(rows.rows(), kDofsPerNode);
    std::vector<mechanics::NodeState> own;
    mechanics::ElementResponse response;
    for (const auto& element : assembly_.elements) {
        own.clear();
        for (const mechanics::NodeIndex node : element->nodes()) own.push_back(states[node]);
        element->evaluate(own, mechanics::Demand::Force, response);
        add_at(element->nodes(), response.force, gradient);
    }
    for (Eigen::Index node = 0; node < gradient.rows(); ++node) {
        const Eigen::Matrix3d spins = geometry::spin_map(rows.row(node).tail<3>().transpose());
        gradient.row(node).tail<3>() = (gradient.row(node).tail<3>() * spins).eval();
    }
    return gradient.topRows(assembly_.reported_nodes);
}

/// Keeps held components; free ones are zero.
NodeValues Session::Impl::at_held(const NodeValues& rows) const {
    NodeValues held = NodeValues::Zero(rows.rows(), kDofsPerNode);
    const auto keep = [&](mechanics::NodeIndex node, int dof) {
        held(node.value, dof) = rows(node.value, dof);
    };
    for (const mechanics::Support& support : assembly_.supports) {
        for (int d = 0; d < kDofsPerNode; ++d) {
            if (support.fixed[static_cast<mechanics::Dof>(d)]) keep(support.node, d);
        }
    }
    for (const auto& given : assembly_.prescribed) keep(given.node, static_cast<int>(given.dof));
    return held;
}

/// Only a tile that is one element, without inner nodes and beams, has strains.
TileLinearization Session::Impl::linear_tile(TileIndex tile) const {
    const std::size_t t = tile;
    TileLinearization result;
    result.nodes = surface_.tessellation.tiles[tile].interface_nodes;
    result.mass = acting_mass(tile);
    const detail::TileStart& start = starts_[t];
    const detail::TileStart& end = starts_[t + 1];
    const bool is_one_element =
        end.element == start.element + 1 && end.beam == start.beam && end.inner_node == start.inner_node;
    if (!is_one_element) return result;
    Eigen::MatrixXd stiffness;
    assembly_.elements[detail::first_element(assembly_, starts_, tile)]->rest_stiffness(stiffness);
    const Eigen::VectorXd displacements =
        detail::rows_of_tile(linear_displacements_, result.nodes).reshaped<Eigen::RowMajor>();
    result.forces = stiffness * displacements;
    result.energy = 0.5 * result.forces.dot(displacements);
    result.strains = turned_back(displacements, tiles_[t].turn);
    return result;
}

Sensitivity Session::Impl::linear_sensitivity(const NodeValues& gradient,
                                              const base::Control& control) const {
    detail::require_gradient(gradient, assembly_.reported_nodes);
    NodeValues all = NodeValues::Zero(std::ssize(assembly_.nodes), kDofsPerNode);
    all.topRows(gradient.rows()) = gradient;
    NodeValues adjoint(all.rows(), kDofsPerNode);
    adjoint.reshaped<Eigen::RowMajor>() =
        solver_->solve_free(all.reshaped<Eigen::RowMajor>().eval(), control).col(0);
    Sensitivity result;
    result.loads = adjoint.topRows(gradient.rows());
    result.held_values = at_held(all - rest_forces(adjoint)).topRows(gradient.rows());
    result.stiffness = -assembly_.loads.cwiseProduct(adjoint).sum();
    for (const TileIndex tile : surface_.tessellation.tiles.indices()) {
        const TileLinearization own = linear_tile(tile);
        detail::TileAdjoint motions{detail::rows_of_tile(adjoint, own.nodes), {}};
        if (own.strains.size() > 0)
            motions.strains = turned_back(motions.motions.reshaped<Eigen::RowMajor>(), tiles_[tile].turn);
        result.tiles.push_back(detail::tile_sensitivity(own, std::move(motions), load_case_.gravity));
    }
    return result;
}

Sensitivity Session::Impl::sensitivity(const NodeValues& gradient, const base::Control& control) {
    if (is_at_equilibrium_ && solved_in_ == reduction::Displacements::Small)
        return linear_sensitivity(gradient, control);
    return simulation::sensitivity(linearize(TileQuantities::Strains, control), gradient, control);
}

}  // namespace fretwork::simulation
