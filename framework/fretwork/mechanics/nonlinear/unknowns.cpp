// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/index.hpp>
#include <fretwork/geometry/rotation.hpp>
#include <fretwork/mechanics/nonlinear/unknowns.hpp>
#include <fretwork/mechanics/structure/coupling.hpp>

#include <algorithm>
#include <cmath>

namespace fretwork::mechanics::nonlinear {
namespace {

using base::at;

std::unique_ptr<sparse::SystemLayout> lay_out(const Assembly& assembly,
                                              const structure::Constraints& constraints,
                                              const base::Control& control) {
    const std::vector<sparse::Components> free = structure::other_components(constraints.held);
    const sparse::NodeGraph graph = structure::coupling_graph(assembly);
    return std::make_unique<sparse::SystemLayout>(graph, free,
                                                  sparse::elimination_order(graph, free, control), control);
}

}  // namespace

Unknowns::Unknowns(const Assembly& assembly, const base::Control& control)
    : assembly_(assembly),
      constraints_(structure::constraints_of(assembly)),
      length_(structure::characteristic_length(assembly)),
      start_(NodeValues::Zero(constraints_.values.rows(), kDofsPerNode)),
      layout_(lay_out(assembly, constraints_, control)) {
    take_up_prescribed();
    NodeValues weights = NodeValues::Ones(static_cast<Eigen::Index>(assembly.nodes.size()), kDofsPerNode);
    weights.leftCols<3>() /= length_ * length_;
    layout_->gather(weights, weights_);
}

void Unknowns::begin_at(const Configuration& start) {
    for (int node = 0; node < static_cast<int>(assembly_.nodes.size()); ++node) {
        for (int d = 0; d < kDofsPerNode; ++d) {
            if (!is_held(node, d)) continue;
            start_(node, d) =
                d < 3 ? start.states[at(node)].displacement[d] : start.rotation_vectors[at(node)][d - 3];
        }
    }
    take_up_prescribed();
}

void Unknowns::refresh() {
    constraints_ = structure::constraints_of(assembly_);
    take_up_prescribed();
}

void Unknowns::take_up_prescribed() {
    prescribed_change_ = constraints_.values - start_;
    find_vector_nodes();
}

void Unknowns::find_vector_nodes() {
    has_prescribed_ = !prescribed_change_.isZero(0.0);
    vector_slot_.assign(assembly_.nodes.size(), -1);
    vector_nodes_.clear();
    for (int node = 0; node < static_cast<int>(assembly_.nodes.size()); ++node) {
        const int held = is_held(node, 3) + is_held(node, 4) + is_held(node, 5);
        const bool prescribed =
            !constraints_.values.row(node).tail<3>().isZero(0.0) || !start_.row(node).tail<3>().isZero(0.0);
        if (held == 0 || (held == 3 && !prescribed)) continue;
        vector_slot_[at(node)] = static_cast<int>(vector_nodes_.size());
        vector_nodes_.push_back(node);
    }
}

bool Unknowns::has_held_rotation(int node) const {
    return is_held(node, 3) || is_held(node, 4) || is_held(node, 5);
}

bool Unknowns::is_held(int node, int dof) const {
    return constraints_.held[at(node)].contains[at(dof)];
}

Configuration Unknowns::rest() const {
    return {std::vector<NodeState>(assembly_.nodes.size()),
            std::vector<Eigen::Vector3d>(assembly_.nodes.size(), Eigen::Vector3d::Zero())};
}

void Unknowns::prescribe(double load_factor, Configuration& configuration) const {
    if (!has_prescribed_) return;
    for (const PrescribedDisplacement& given : assembly_.prescribed) {
        const auto node = at(given.node.value);
        const auto dof = static_cast<int>(given.dof);
        // This form is exact at the full load.
        const double value = load_factor * given.value + (1.0 - load_factor) * start_(given.node.value, dof);
        if (dof < 3) {
            configuration.states[node].displacement[dof] = value;
        } else {
            configuration.rotation_vectors[node][dof - 3] = value;
            configuration.states[node].rotation = geometry::exponential(configuration.rotation_vectors[node]);
        }
    }
}

NodeValues Unknowns::hold(Configuration& configuration) const {
    NodeValues motions = NodeValues::Zero(static_cast<Eigen::Index>(assembly_.nodes.size()), kDofsPerNode);
    for (int node = 0; node < static_cast<int>(assembly_.nodes.size()); ++node) {
        Eigen::Vector3d& shift = configuration.states[at(node)].displacement;
        Eigen::Vector3d& vector = configuration.rotation_vectors[at(node)];
        for (int d = 0; d < kDofsPerNode; ++d) {
            if (!is_held(node, d)) continue;
            double& component = d < 3 ? shift[d] : vector[d - 3];
            motions(node, d) = constraints_.values(node, d) - component;
            component = constraints_.values(node, d);
        }
        if (!motions.row(node).tail<3>().isZero(0.0))
            configuration.states[at(node)].rotation = geometry::exponential(vector);
    }
    return motions;
}

void Unknowns::move(const Eigen::VectorXd& step, Configuration& configuration) const {
    for (int node = 0; node < static_cast<int>(assembly_.nodes.size()); ++node) {
        NodeState& state = configuration.states[at(node)];
        Eigen::Vector3d turn = Eigen::Vector3d::Zero();
        bool turns = false;
        for (int c = 0; c < 3; ++c) {
            const int shift = layout_->equation(node, c);
            if (shift >= 0) state.displacement[c] += step[shift];
            const int rotation = layout_->equation(node, c + 3);
            if (rotation < 0) continue;
            turn[c] = step[rotation];
            turns = true;
        }
        if (!turns) continue;
        Eigen::Vector3d& vector = configuration.rotation_vectors[at(node)];
        if (vector_slot_[at(node)] >= 0) {
            vector += turn;
            state.rotation = geometry::exponential(vector);
        } else {
            state.rotation = (geometry::exponential(turn) * state.rotation).normalized();
            vector = geometry::logarithm_near(state.rotation, vector);
        }
    }
}

void Unknowns::unwind(const Configuration& last, Configuration& configuration) const {
    for (std::size_t node = 0; node < assembly_.nodes.size(); ++node) {
        if (vector_slot_[node] >= 0) continue;
        configuration.rotation_vectors[node] =
            geometry::logarithm_near(configuration.states[node].rotation, last.rotation_vectors[node]);
    }
}

Eigen::VectorXd Unknowns::step_between(const Configuration& from, const Configuration& to) const {
    NodeValues table(static_cast<Eigen::Index>(assembly_.nodes.size()), kDofsPerNode);
    for (std::size_t node = 0; node < assembly_.nodes.size(); ++node) {
        const auto row = static_cast<Eigen::Index>(node);
        table.row(row).head<3>() =
            (to.states[node].displacement - from.states[node].displacement).transpose();
        const Eigen::Vector3d turn =
            vector_slot_[node] >= 0
                ? Eigen::Vector3d(to.rotation_vectors[node] - from.rotation_vectors[node])
                : geometry::logarithm(to.states[node].rotation * from.states[node].rotation.conjugate());
        table.row(row).tail<3>() = turn.transpose();
    }
    Eigen::VectorXd step;
    layout_->gather(table, step);
    return step;
}

Eigen::VectorXd Unknowns::rate_of_steps(const Eigen::VectorXd& step, const Eigen::VectorXd& rate) const {
    Eigen::VectorXd result = rate;
    for (int node = 0; node < static_cast<int>(assembly_.nodes.size()); ++node) {
        const int first = layout_->equation(node, 3);
        if (first < 0 || vector_slot_[at(node)] >= 0) continue;
        result.segment<3>(first) =
            geometry::inverse_spin_map(step.segment<3>(first)) * rate.segment<3>(first);
    }
    return result;
}

double Unknowns::largest_rotation(const Eigen::VectorXd& step) const {
    double largest = 0.0;
    for (int node = 0; node < static_cast<int>(assembly_.nodes.size()); ++node) {
        double square = 0.0;
        for (int d = 3; d < kDofsPerNode; ++d) {
            const int equation = layout_->equation(node, d);
            if (equation >= 0) square += step[equation] * step[equation];
        }
        largest = std::max(largest, square);
    }
    return std::sqrt(largest);
}

double Unknowns::largest_component(const Eigen::VectorXd& step) const {
    double largest = 0.0;
    for (int node = 0; node < static_cast<int>(assembly_.nodes.size()); ++node) {
        for (int d = 0; d < kDofsPerNode; ++d) {
            const int equation = layout_->equation(node, d);
            if (equation >= 0)
                largest = std::max(largest, std::abs(step[equation]) / (d < 3 ? length_ : 1.0));
        }
    }
    return largest;
}

}  // namespace fretwork::mechanics::nonlinear
