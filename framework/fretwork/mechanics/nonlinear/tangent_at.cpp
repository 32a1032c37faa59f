// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/geometry/rotation.hpp>
#include <fretwork/mechanics/nonlinear/tangent_at.hpp>

#include <Eigen/LU>

#include <algorithm>
#include <utility>

namespace fretwork::mechanics {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

std::size_t place_of(Index number) {
    return number;
}

/// The rows of a node's rotation in a table of columns.
auto rotation_of(MatrixXd& rows, Index node) {
    return rows.middleRows<3>(kDofsPerNode * node + 3);
}

}  // namespace

EquilibriumTangent::Impl::Impl(const Parts& parts, const base::Control& control) : parts_(parts) {
    for (const Eigen::Vector3d& vector : parts_.configuration.rotation_vectors)
        spin_maps_.push_back(geometry::spin_map(vector));
    if (parts_.has_factors) {
        parts_.system.refresh(control);
        parts_.system.evaluate(parts_.configuration, 1.0);
    } else {
        factorize(control);
    }
}

void EquilibriumTangent::Impl::factorize(const base::Control& control) {
    parts_.system.refresh(control);
    parts_.has_factors = false;  // stays false if a call throws
    if (!parts_.mixed.begin(parts_.configuration, 1.0))
        throw base::NumericalError("the equilibrium is at a stability limit: it has no derivative");
    parts_.has_factors = is_exact_ = true;
}

Index EquilibriumTangent::Impl::nodes() const {
    return std::ssize(parts_.configuration.states);
}

MatrixXd EquilibriumTangent::Impl::solve(const MatrixXd& right_sides, nonlinear::Newton::Side side,
                                         const base::Control& control) {
    parts_.options.control = control;
    if (is_exact_ && !parts_.system.has_skew_part()) return parts_.newton.solve_plainly(right_sides);
    if (!is_exact_) {
        if (auto refined = parts_.newton.solve_refined(right_sides, side)) return std::move(*refined);
        factorize(control);
    }
    auto found = parts_.newton.solve_refined(right_sides, side);
    if (!found) throw base::NumericalError("the tangent of the equilibrium is nearly singular");
    return std::move(*found);
}

MatrixXd EquilibriumTangent::Impl::equations_of(const MatrixXd& rows) const {
    const auto& layout = unknowns().layout();
    MatrixXd result(layout.equations(), rows.cols());
    for (Index node = 0; node < nodes(); ++node) {
        for (int d = 0; d < kDofsPerNode; ++d) {
            const int equation = layout.equation(static_cast<int>(node), d);
            if (equation >= 0) result.row(equation) = rows.row(kDofsPerNode * node + d);
        }
    }
    return result;
}

MatrixXd EquilibriumTangent::Impl::rows_of(const MatrixXd& steps) const {
    const auto& layout = unknowns().layout();
    MatrixXd result = MatrixXd::Zero(kDofsPerNode * nodes(), steps.cols());
    for (Index node = 0; node < nodes(); ++node) {
        for (int d = 0; d < kDofsPerNode; ++d) {
            const int equation = layout.equation(static_cast<int>(node), d);
            if (equation >= 0) result.row(kDofsPerNode * node + d) = steps.row(equation);
        }
    }
    return result;
}

void EquilibriumTangent::Impl::moments_to_vectors(MatrixXd& rows) const {
    for (const int node : unknowns().vector_nodes())
        rotation_of(rows, node) = (spin_maps_[place_of(node)].transpose() * rotation_of(rows, node)).eval();
}

void EquilibriumTangent::Impl::vectors_to_spins(MatrixXd& rows) const {
    for (const int node : unknowns().vector_nodes())
        rotation_of(rows, node) = (spin_maps_[place_of(node)] * rotation_of(rows, node)).eval();
}

void EquilibriumTangent::Impl::gradients_to_spins(MatrixXd& rows) const {
    for (Index node = 0; node < nodes(); ++node) {
        if (unknowns().vector_slot(static_cast<int>(node)) >= 0) continue;
        rotation_of(rows, node) =
            spin_maps_[place_of(node)].transpose().partialPivLu().solve(rotation_of(rows, node)).eval();
    }
}

void EquilibriumTangent::Impl::spins_to_vectors(MatrixXd& rows) const {
    for (Index node = 0; node < nodes(); ++node)
        rotation_of(rows, node) =
            spin_maps_[place_of(node)].partialPivLu().solve(rotation_of(rows, node)).eval();
}

const Element& EquilibriumTangent::Impl::element(std::size_t index) const {
    return *unknowns().assembly().elements[index];
}

std::vector<NodeState> EquilibriumTangent::Impl::states_of(const Element& element) const {
    std::vector<NodeState> states;
    for (const NodeIndex node : element.nodes())
        states.push_back(parts_.configuration.states[place_of(node.value)]);
    return states;
}

MatrixXd EquilibriumTangent::Impl::strain_slopes(std::size_t index) const {
    const Element& own = element(index);
    const Index stresses = own.stress_count();
    if (stresses == 0) return {};
    const Index motions = std::ssize(own.nodes()) * kDofsPerNode;
    const Eigen::VectorXd given = Eigen::VectorXd::Zero(stresses);
    Eigen::VectorXd found(stresses);
    MatrixXd slopes(stresses, motions);
    MixedResponse response;
    own.evaluate_mixed(states_of(own), Demand::Tangent,
                       {{given.data(), place_of(stresses)},
                        {found.data(), place_of(stresses)},
                        {slopes.data(), place_of(slopes.size())}},
                       response);
    return slopes;
}

Eigen::VectorXd EquilibriumTangent::Impl::internal_forces(std::size_t index) const {
    ElementResponse response;
    element(index).evaluate(states_of(element(index)), Demand::Force, response);
    return response.force;
}

/// The change of an element's forces on its nodes (6n) along motions of all nodes of the structure.
MatrixXd EquilibriumTangent::Impl::forces_of(const Element& own, const MatrixXd& motions) const {
    MatrixXd local(std::ssize(own.nodes()) * kDofsPerNode, motions.cols());
    for (Index i = 0; i < std::ssize(own.nodes()); ++i)
        local.middleRows<kDofsPerNode>(kDofsPerNode * i) =
            motions.middleRows<kDofsPerNode>(kDofsPerNode * own.nodes()[place_of(i)].value);
    ElementResponse response;
    own.evaluate(states_of(own), Demand::Tangent, response);
    return response.tangent * local;
}

/// Add the terms of the tangent, or of its transpose, that belong to single vector nodes. They refer to the
/// components of the rotation vector.
void EquilibriumTangent::Impl::add_own_terms(const MatrixXd& motions, nonlinear::Newton::Side side,
                                             MatrixXd& forces) const {
    const double sign = side == nonlinear::Newton::Side::Tangent ? 1.0 : -1.0;
    const NodeValues reactions =
        parts_.system.reactions();  // internal minus applied forces, at held rotations
    for (const int node : unknowns().vector_nodes()) {
        const Eigen::Vector3d excess = reactions.row(node).tail<3>().transpose();
        const Eigen::Vector3d moment = unknowns().assembly().loads.row(node).tail<3>().transpose();
        const Eigen::Matrix3d& map = spin_maps_[place_of(node)];
        Eigen::Matrix3d change =
            geometry::spin_map_derivative(parts_.configuration.rotation_vectors[place_of(node)], excess);
        change = 0.5 * (change + change.transpose()).eval();
        const Eigen::Matrix3d skew = -0.5 * map.transpose() * geometry::cross_matrix(moment) * map;
        rotation_of(forces, node) +=
            (change + sign * skew) * map.inverse() * motions.middleRows<3>(Index{kDofsPerNode} * node + 3);
    }
}

bool EquilibriumTangent::Impl::is_held(Index node, int dof) const {
    return unknowns().is_held(static_cast<int>(node), dof);
}

/// The change of the forces (conjugate to the unknowns) of all elements with a held node, along motions.
MatrixXd EquilibriumTangent::Impl::forces_at_held(const MatrixXd& motions,
                                                  nonlinear::Newton::Side side) const {
    const auto has_held = [this](NodeIndex node) {
        for (int d = 0; d < kDofsPerNode; ++d) {
            if (is_held(node.value, d)) return true;
        }
        return false;
    };
    MatrixXd forces = MatrixXd::Zero(motions.rows(), motions.cols());
    for (const auto& own : unknowns().assembly().elements) {
        if (std::ranges::none_of(own->nodes(), has_held)) continue;
        const MatrixXd local = forces_of(*own, motions);
        for (Index i = 0; i < std::ssize(own->nodes()); ++i)
            forces.middleRows<kDofsPerNode>(kDofsPerNode * own->nodes()[place_of(i)].value) +=
                local.middleRows<kDofsPerNode>(kDofsPerNode * i);
    }
    moments_to_vectors(forces);
    add_own_terms(motions, side, forces);
    return forces;
}

MatrixXd EquilibriumTangent::Impl::motions_of_held(const MatrixXd& values, const base::Control& control) {
    MatrixXd motions = MatrixXd::Zero(values.rows(), values.cols());
    for (Index node = 0; node < nodes(); ++node) {
        for (int d = 0; d < kDofsPerNode; ++d) {
            const Index row = kDofsPerNode * node + d;
            if (is_held(node, d)) motions.row(row) = values.row(row);
        }
    }
    MatrixXd spins = motions;
    vectors_to_spins(spins);
    const MatrixXd forces = forces_at_held(spins, nonlinear::Newton::Side::Tangent);
    motions -= rows_of(solve(equations_of(forces), nonlinear::Newton::Side::Tangent, control));
    vectors_to_spins(motions);
    return motions;
}

MatrixXd EquilibriumTangent::Impl::by_held_values(const MatrixXd& gradients, const MatrixXd& adjoint) const {
    const MatrixXd forces = forces_at_held(adjoint, nonlinear::Newton::Side::Transposed);
    MatrixXd result = MatrixXd::Zero(adjoint.rows(), adjoint.cols());
    for (Index node = 0; node < nodes(); ++node) {
        for (int d = 0; d < kDofsPerNode; ++d) {
            const Index row = kDofsPerNode * node + d;
            if (is_held(node, d)) result.row(row) = gradients.row(row) - forces.row(row);
        }
    }
    return result;
}

std::vector<MatrixXd> EquilibriumTangent::Impl::flexibilities(std::span<const std::size_t> elements,
                                                              const base::Control& control) {
    parts_.options.control = control;
    if (!is_exact_) factorize(control);
    const auto& layout = unknowns().layout();
    std::vector<std::vector<int>> cliques;
    std::vector<std::vector<Index>> places;
    for (const std::size_t index : elements) {
        auto& clique = cliques.emplace_back();
        auto& own = places.emplace_back();
        Index row = 0;
        for (const NodeIndex node : element(index).nodes()) {
            for (int d = 0; d < kDofsPerNode; ++d, ++row) {
                if (layout.equation(node.value, d) < 0) continue;
                clique.push_back(layout.equation(node.value, d));
                own.push_back(row);
            }
        }
    }
    const std::vector<MatrixXd> blocks = parts_.newton.inverse_blocks(cliques);
    std::vector<MatrixXd> result;
    for (std::size_t i = 0; i < elements.size(); ++i) {
        const auto nodes = element(elements[i]).nodes();
        const Index size = std::ssize(nodes) * kDofsPerNode;
        MatrixXd& flexibility = result.emplace_back(MatrixXd::Zero(size, size));
        flexibility(places[i], places[i]) = blocks[i];
        for (Index n = 0; n < std::ssize(nodes); ++n) {
            if (unknowns().vector_slot(nodes[place_of(n)].value) < 0) continue;
            const Eigen::Matrix3d& map = spin_maps_[place_of(nodes[place_of(n)].value)];
            auto rows = flexibility.middleRows<3>(kDofsPerNode * n + 3);
            rows = (map * rows).eval();
            auto columns = flexibility.middleCols<3>(kDofsPerNode * n + 3);
            columns = (columns * map.transpose()).eval();
        }
    }
    return result;
}

}  // namespace fretwork::mechanics
