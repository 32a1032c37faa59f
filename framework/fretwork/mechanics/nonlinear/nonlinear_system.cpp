// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/index.hpp>
#include <fretwork/base/parallel.hpp>
#include <fretwork/geometry/rotation.hpp>
#include <fretwork/mechanics/nonlinear/nonlinear_system.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace fretwork::mechanics::nonlinear {
namespace {

using base::at;

/// The size of a batch of tangents, and the share of one thread at a time, as numbers of entries. Threads
/// evaluate a batch, which stays in the cache, and then the tangents are added in order.
constexpr std::size_t kBatchNumbers = 300'000;
constexpr std::size_t kPieceNumbers = 10'000;
/// Displacements, as a multiple of the length of the elements, for which rounding is allowed.
constexpr double kRoundingOfMotion = 100.0;

/// The number of entries in the tangents of all elements.
std::size_t tangent_numbers(const Assembly& assembly) {
    std::size_t sum = 0;
    for (const auto& element : assembly.elements) {
        const std::size_t size = element->nodes().size() * kDofsPerNode;
        sum += size * size;
    }
    return sum;
}

/// The rounding of the forces on each node whose elements are near rest: the rounding of their geometry times
/// their stiffness. A stiff element elsewhere adds nothing.
NodeValues rounding_forces(const Assembly& assembly, double length) {
    constexpr double kRoundings = 8.0;
    NodeValues forces = NodeValues::Zero(static_cast<Eigen::Index>(assembly.nodes.size()), kDofsPerNode);
    Eigen::MatrixXd stiffness;
    for (const auto& element : assembly.elements) {
        element->rest_stiffness(stiffness);
        const auto nodes = element->nodes();
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            const auto own =
                stiffness.diagonal().segment<kDofsPerNode>(static_cast<Eigen::Index>(i) * kDofsPerNode);
            forces.row(nodes[i].value).head<3>().array() += length * own.head<3>().maxCoeff();
            forces.row(nodes[i].value).tail<3>().array() += own.tail<3>().maxCoeff();
        }
    }
    return kRoundings * std::numeric_limits<double>::epsilon() * forces;
}

}  // namespace

NonlinearSystem::NonlinearSystem(const Assembly& assembly, int threads, const base::Control& control)
    : unknowns_(assembly, {.stop = control.stop}), control_{.stop = control.stop} {
    const std::size_t numbers = tangent_numbers(assembly);
    if (numbers >= kBatchNumbers / 2) threads_ = base::resolved_thread_count(threads);
    if (threads_ > 1) {
        const std::size_t one = numbers / assembly.elements.size();
        batch_ = std::max<std::size_t>(1, kBatchNumbers / one);
        piece_ = std::max<std::size_t>(1, kPieceNumbers / one);
    }
    answers_.resize(batch_);
    values_.resize(unknowns_.layout().row().size());
    start_loads_.setZero(std::ssize(assembly.nodes), kDofsPerNode);
    take_up_loads();
}

void NonlinearSystem::refresh(const base::Control& control) {
    control_.stop = control.stop;
    unknowns_.refresh();
    take_up_loads();
}

void NonlinearSystem::begin_at(const Configuration& start, NodeValues loads) {
    unknowns_.begin_at(start);
    start_loads_ = std::move(loads);
    take_up_loads();
}

NodeValues NonlinearSystem::loads_at(double load_factor) const {
    return load_factor * unknowns_.assembly().loads + (1.0 - load_factor) * start_loads_;
}

void NonlinearSystem::take_up_loads() {
    const Assembly& assembly = unknowns_.assembly();
    load_change_ = assembly.loads - start_loads_;
    const auto has_moment = [&](int node) {
        return !start_loads_.row(node).tail<3>().isZero(0.0) ||
               !assembly.loads.row(node).tail<3>().isZero(0.0);
    };
    moment_nodes_.clear();
    for (int node = 0; node < static_cast<int>(assembly.nodes.size()); ++node) {
        const int free =
            3 - unknowns_.is_held(node, 3) - unknowns_.is_held(node, 4) - unknowns_.is_held(node, 5);
        if (free >= 2 && has_moment(node)) moment_nodes_.push_back(node);
    }
    if (rounding_.size() == 0 || rounded_elements_ != assembly.elements) {
        unknowns_.layout().gather(rounding_forces(assembly, unknowns_.length()), rounding_);
        rounded_elements_ = assembly.elements;
    }
    spin_maps_.resize(unknowns_.vector_nodes().size());
    prescribed_rate_.setZero(static_cast<Eigen::Index>(assembly.nodes.size()), kDofsPerNode);
}

void NonlinearSystem::map_spins(const Configuration& configuration) {
    for (std::size_t i = 0; i < unknowns_.vector_nodes().size(); ++i)
        spin_maps_[i] = geometry::spin_map(configuration.rotation_vectors[at(unknowns_.vector_nodes()[i])]);
}

/// Map columns from spins to components of the rotation vector, at nodes at which these are the unknowns.
void NonlinearSystem::map_columns(std::span<const NodeIndex> nodes,
                                  Eigen::Ref<Eigen::MatrixXd> slopes) const {
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const int slot = unknowns_.vector_slot(nodes[i].value);
        if (slot < 0) continue;
        const Eigen::Index place = static_cast<Eigen::Index>(i) * kDofsPerNode + 3;
        slopes.middleCols<3>(place) = (slopes.middleCols<3>(place) * spin_maps_[at(slot)]).eval();
    }
}

void NonlinearSystem::map_to_unknowns(std::span<const NodeIndex> nodes, Eigen::MatrixXd& tangent) const {
    map_columns(nodes, tangent);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const int slot = unknowns_.vector_slot(nodes[i].value);
        if (slot < 0) continue;
        const Eigen::Index place = static_cast<Eigen::Index>(i) * kDofsPerNode + 3;
        tangent.middleRows<3>(place) =
            (spin_maps_[at(slot)].transpose() * tangent.middleRows<3>(place)).eval();
    }
}

void NonlinearSystem::add_prescribed_rate(std::span<const NodeIndex> nodes, const Eigen::MatrixXd& tangent) {
    for (std::size_t j = 0; j < nodes.size(); ++j) {
        const auto given = unknowns_.prescribed_change().row(nodes[j].value);
        if (given.isZero(0.0)) continue;
        const Eigen::VectorXd rate =
            tangent.middleCols<kDofsPerNode>(static_cast<Eigen::Index>(j) * kDofsPerNode) * given.transpose();
        for (std::size_t i = 0; i < nodes.size(); ++i)
            prescribed_rate_.row(nodes[i].value) +=
                rate.segment<kDofsPerNode>(static_cast<Eigen::Index>(i) * kDofsPerNode).transpose();
    }
}

void NonlinearSystem::for_elements(std::size_t count, const std::function<void(std::size_t)>& body) const {
    base::parallel_for((count + piece_ - 1) / piece_, threads_, [&](std::size_t piece) {
        control_.check();
        const std::size_t end = std::min(count, (piece + 1) * piece_);
        for (std::size_t i = piece * piece_; i < end; ++i) body(i);
    });
}

/// Evaluate and add all elements. Elements are added in their order, so sums do not depend on the threads.
void NonlinearSystem::add_elements(const Configuration& configuration, const Pass& pass) {
    for (std::size_t first = 0; first < unknowns_.assembly().elements.size(); first += batch_) {
        const std::size_t count = std::min(batch_, unknowns_.assembly().elements.size() - first);
        control_.check();
        if (threads_ == 1) {
            evaluate_element(first, configuration, pass, answers_[0]);
        } else {
            for_elements(
                count, [&](std::size_t i) { evaluate_element(first + i, configuration, pass, answers_[i]); });
        }
        for (std::size_t i = 0; i < count; ++i) add_answer(first + i, answers_[i], pass);
    }
}

void NonlinearSystem::evaluate_element(std::size_t index, const Configuration& configuration,
                                       const Pass& pass, Answer& answer) const {
    const Element& element = *unknowns_.assembly().elements[index];
    const auto states = states_of(element, configuration);
    if (pass.stresses == nullptr) {
        element.evaluate(states, pass.demand, answer.response);
    } else {
        element.evaluate_mixed(states, pass.demand, pass.stresses->of(index), answer.response);
    }
    if (StressWorkspace* const lagging = pass.lagging_stresses()) {
        answer.lag.setZero(answer.response.force.size());
        lagging->add_lag(index, answer.lag);
    } else if (pass.demand == Demand::Tangent && !unknowns_.vector_nodes().empty()) {
        map_to_unknowns(element.nodes(), answer.response.tangent);
        if (pass.stresses != nullptr) map_columns(element.nodes(), pass.stresses->slopes(index));
    }
}

void NonlinearSystem::extrapolate(const NodeValues& motions, StressWorkspace& stresses) const {
    for_elements(unknowns_.assembly().elements.size(), [&](std::size_t index) {
        thread_local Eigen::VectorXd motion;
        const auto nodes = unknowns_.assembly().elements[index]->nodes();
        motion.resize(std::ssize(nodes) * kDofsPerNode);
        for (std::size_t i = 0; i < nodes.size(); ++i)
            motion.segment<kDofsPerNode>(static_cast<Eigen::Index>(i) * kDofsPerNode) =
                motions.row(nodes[i].value).transpose();
        stresses.extrapolate(index, motion);
    });
}

/// The states of an element's nodes; valid until the next call on the same thread.
std::span<const NodeState> NonlinearSystem::states_of(const Element& element,
                                                      const Configuration& configuration) {
    thread_local std::vector<NodeState> states;
    const auto nodes = element.nodes();
    states.resize(nodes.size());
    for (std::size_t i = 0; i < nodes.size(); ++i) states[i] = configuration.states[at(nodes[i].value)];
    return states;
}

NonlinearSystem::RelativeTurn NonlinearSystem::relative_turn(const Configuration& configuration,
                                                             const Configuration& last) const {
    RelativeTurn result;
    for (const auto& element : unknowns_.assembly().elements) {
        const double before = element->relative_turn(states_of(*element, last));
        const double after = element->relative_turn(states_of(*element, configuration));
        result.largest = std::max(result.largest, std::abs(after));
        result.largest_change = std::max(result.largest_change, std::abs(after - before));
    }
    return result;
}

void NonlinearSystem::add_answer(std::size_t index, const Answer& answer, const Pass& pass) {
    const auto nodes = unknowns_.assembly().elements[index]->nodes();
    const auto add = [&nodes](const Eigen::VectorXd& values, NodeValues& table) {
        for (std::size_t i = 0; i < nodes.size(); ++i)
            table.row(nodes[i].value) +=
                values.segment<kDofsPerNode>(static_cast<Eigen::Index>(i) * kDofsPerNode).transpose();
    };
    energy_ += answer.response.energy;
    add(answer.response.force, internal_);
    if (pass.stresses != nullptr) add(answer.response.given_force, given_internal_);
    if (pass.has_lag()) add(answer.lag, lag_);
    if (pass.demand == Demand::Force) return;
    unknowns_.layout().add(index, answer.response.tangent, values_);
    if (unknowns_.has_prescribed()) add_prescribed_rate(nodes, answer.response.tangent);
}

/// Add the terms of moments to the tangent. At vector nodes, these terms are the change of the spin map,
/// multiplied by the unbalanced moment that the supports carry. At nodes with at least two free rotations,
/// they are the skew part of moments of fixed direction.
/// @param internal  internal forces of the stresses in the tangent
void NonlinearSystem::add_moment_terms(const Configuration& configuration, const NodeValues& loads,
                                       const NodeValues& internal) {
    skew_.clear();
    for (const int node : unknowns_.vector_nodes()) {
        const Eigen::Vector3d excess = (internal.row(node) - loads.row(node)).tail<3>().transpose();
        Eigen::Matrix3d change =
            geometry::spin_map_derivative(configuration.rotation_vectors[at(node)], excess);
        change = 0.5 * (change + change.transpose()).eval();
        Eigen::Matrix<double, kDofsPerNode, kDofsPerNode> block =
            Eigen::Matrix<double, kDofsPerNode, kDofsPerNode>::Zero();
        block.bottomRightCorner<3, 3>() = change;
        unknowns_.layout().add_node(node, block, values_);
        if (!unknowns_.has_prescribed()) continue;
        const Eigen::Vector3d given = unknowns_.prescribed_change().row(node).tail<3>();
        const Eigen::Vector3d rate = (change + skew_of_moment(node, loads)) * given;
        prescribed_rate_.row(node).tail<3>() += rate.transpose();
    }
    for (const int node : moment_nodes_) {
        skew_.push_back({{unknowns_.layout().equation(node, 3), unknowns_.layout().equation(node, 4),
                          unknowns_.layout().equation(node, 5)},
                         skew_of_moment(node, loads)});
    }
}

/// The skew part of the tangent by a node's applied moment.
Eigen::Matrix3d NonlinearSystem::skew_of_moment(int node, const NodeValues& loads) const {
    const Eigen::Vector3d moment = loads.row(node).tail<3>().transpose();
    Eigen::Matrix3d skew = -0.5 * geometry::cross_matrix(moment);
    const int slot = unknowns_.vector_slot(node);
    if (slot < 0) return skew;
    return spin_maps_[at(slot)].transpose() * skew * spin_maps_[at(slot)];
}

/// Forces with their moments mapped to the components of the rotation vector, at nodes at which these are the
/// unknowns.
NodeValues NonlinearSystem::mapped(NodeValues forces) const {
    for (std::size_t i = 0; i < unknowns_.vector_nodes().size(); ++i) {
        auto moment = forces.row(unknowns_.vector_nodes()[i]).tail<3>();
        moment = (moment * spin_maps_[i]).eval();
    }
    return forces;
}

void NonlinearSystem::gather_unbalanced(double load_factor, const NodeValues& loads) {
    const NodeValues unbalanced = mapped(forces_);
    NodeValues rate = mapped(load_change_);
    if (unknowns_.has_prescribed()) rate -= prescribed_rate_;
    unknowns_.layout().gather(unbalanced, unbalanced_);
    unknowns_.layout().gather(rate, load_rate_);
    double square = 0.0;
    for (Eigen::Index node = 0; node < unbalanced.rows(); ++node) {
        for (int d = 0; d < kDofsPerNode; ++d) {
            if (unknowns_.is_held(static_cast<int>(node), d)) continue;
            const double value = unbalanced(node, d) / (d < 3 ? 1.0 : unknowns_.length());
            square += value * value;
        }
    }
    const double scale = structure::force_norm(loads, unknowns_.length()) +
                         structure::force_norm(reactions(), unknowns_.length());
    const bool is_unloaded = loads.isZero(0.0);
    is_free_of_forces_ =
        is_unloaded && std::max(scale, std::sqrt(square)) <= kRoundingOfMotion * rounding_.norm();
    const bool is_rest = is_unloaded && is_rounding() && unknowns_.holds_at_rest(load_factor);
    relative_residual_ = square == 0.0 || is_free_of_forces_ || is_rest ? 0.0 : std::sqrt(square) / scale;
}

NodeValues NonlinearSystem::held_forces() const {
    if (is_free_of_forces_) return NodeValues::Zero(forces_.rows(), kDofsPerNode);
    return reactions();
}

void NonlinearSystem::evaluate(const Configuration& configuration, double load_factor, Demand demand) {
    evaluate(configuration, load_factor, Pass{demand});
}

void NonlinearSystem::evaluate_mixed(const Configuration& configuration, double load_factor, Demand demand,
                                     StressWorkspace& stresses) {
    evaluate(configuration, load_factor, Pass{demand, &stresses});
}

void NonlinearSystem::evaluate(const Configuration& configuration, double load_factor, const Pass& pass) {
    const auto nodes = static_cast<Eigen::Index>(unknowns_.assembly().nodes.size());
    const bool mixed = pass.stresses != nullptr;
    internal_.setZero(nodes, kDofsPerNode);
    if (mixed) given_internal_.setZero(nodes, kDofsPerNode);
    if (pass.has_lag()) lag_.setZero(nodes, kDofsPerNode);
    if (pass.demand == Demand::Tangent) {
        std::fill(values_.begin(), values_.end(), 0.0);
        if (unknowns_.has_prescribed()) prescribed_rate_.setZero(nodes, kDofsPerNode);
    }
    energy_ = 0.0;
    map_spins(configuration);
    add_elements(configuration, pass);
    const NodeValues loads = loads_at(load_factor);
    forces_ = loads - internal_;
    if (pass.demand == Demand::Tangent)
        add_moment_terms(configuration, loads, mixed ? given_internal_ : internal_);
    gather_unbalanced(load_factor, loads);
    if (pass.has_lag()) unknowns_.layout().gather(mapped(loads - given_internal_) - lag_, mixed_unbalanced_);
}

Eigen::VectorXd NonlinearSystem::lag() const {
    Eigen::VectorXd lag;
    unknowns_.layout().gather(lag_, lag);
    return lag;
}

Eigen::VectorXd NonlinearSystem::skew_product(const Eigen::VectorXd& x) const {
    Eigen::VectorXd y = Eigen::VectorXd::Zero(x.size());
    for (const SkewBlock& block : skew_) {
        for (int i = 0; i < 3; ++i) {
            for (int j = 0; j < 3; ++j) {
                if (block.equation[at(i)] >= 0 && block.equation[at(j)] >= 0)
                    y[block.equation[at(i)]] += block.matrix(i, j) * x[block.equation[at(j)]];
            }
        }
    }
    return y;
}

bool NonlinearSystem::is_conservative() const {
    // Moments that act elsewhere on the path may be zero here.
    const auto is_zero = [](const SkewBlock& block) { return block.matrix.isZero(0.0); };
    return !unknowns_.assembly().has_moments || std::ranges::all_of(skew_, is_zero);
}

NodeValues NonlinearSystem::reactions() const {
    NodeValues result = NodeValues::Zero(forces_.rows(), kDofsPerNode);
    for (Eigen::Index node = 0; node < forces_.rows(); ++node) {
        for (int d = 0; d < 3; ++d) {
            if (unknowns_.is_held(static_cast<int>(node), d)) result(node, d) = -forces_(node, d);
        }
        if (unknowns_.has_held_rotation(static_cast<int>(node)))
            result.row(node).tail<3>() = -forces_.row(node).tail<3>();
    }
    return result;
}

Solution NonlinearSystem::describe(const Configuration& configuration, double load_factor) const {
    const auto all = static_cast<Eigen::Index>(configuration.states.size());
    const Eigen::Index reported = unknowns_.assembly().reported_nodes;
    Solution solution;
    solution.load_factor = load_factor;
    solution.energy = energy_;
    solution.residual = relative_residual_;
    solution.displacements.resize(reported, kDofsPerNode);
    solution.inner_displacements.resize(all - reported, kDofsPerNode);
    for (int node = 0; node < static_cast<int>(all); ++node) {
        auto row = node < reported ? solution.displacements.row(node)
                                   : solution.inner_displacements.row(node - reported);
        row << configuration.states[at(node)].displacement.transpose(),
            configuration.rotation_vectors[at(node)].transpose();
    }
    solution.reactions = reactions().topRows(reported);
    return solution;
}

}  // namespace fretwork::mechanics::nonlinear
