// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/mechanics/assembly.hpp>
#include <fretwork/mechanics/linear_solver.hpp>
#include <fretwork/mechanics/modes.hpp>
#include <fretwork/mechanics/node_states.hpp>
#include <fretwork/mechanics/paths/linear_range.hpp>

#include <algorithm>
#include <cmath>

namespace fretwork::mechanics {
namespace {

/// The size (rad, or displacement over the size of the elements) to which the linear solution is scaled for
/// computing forces. Terms of higher order are then a ten-thousandth of the wanted terms, and rounding is
/// smaller still.
constexpr double kSmall = 1e-2;

double largest_translation(const NodeValues& rows) {
    return rows.leftCols<3>().rowwise().norm().maxCoeff();
}

/// The internal forces of the elements in a state.
NodeValues internal_forces(const Assembly& assembly, const NodeValues& state, const base::Control& control) {
    const std::vector<NodeState> states = node_states(state);
    NodeValues forces = NodeValues::Zero(state.rows(), kDofsPerNode);
    std::vector<NodeState> own;
    ElementResponse response;
    for (const auto& element : assembly.elements) {
        control.check();
        own.clear();
        for (const NodeIndex node : element->nodes()) own.push_back(states[node]);
        element->evaluate(own, Demand::Force, response);
        Eigen::Index first = 0;
        for (const NodeIndex node : element->nodes()) {
            forces.row(node) += response.force.segment<kDofsPerNode>(first).transpose();
            first += kDofsPerNode;
        }
    }
    return forces;
}

/// The mean distance between the first two nodes of an element.
double element_size(const Assembly& assembly) {
    double sum = 0.0;
    for (const auto& element : assembly.elements) {
        const auto place = [&](std::size_t i) { return assembly.nodes[element->nodes()[i]]; };
        sum += (place(1) - place(0)).norm();
    }
    return sum / static_cast<double>(assembly.elements.size());
}

class PathTerms {
  public:
    PathTerms(const Assembly& assembly, const LinearRangeOptions& options)
        : assembly_(assembly),
          options_(options),
          solver_(assembly, {.threads = options.threads, .control = options.control}) {
        const Solution linear = solver_.solve(options.control);
        first_.resize(linear.displacements.rows() + linear.inner_displacements.rows(), kDofsPerNode);
        first_ << linear.displacements, linear.inner_displacements;
    }

    [[nodiscard]] const NodeValues& first() const { return first_; }

    LinearRange range() {
        LinearRange range;
        const double largest = largest_translation(first_);
        if (!(largest > 0.0) || !std::isfinite(largest)) return range;
        range.loses_stability = !is_stable();
        small_ = kSmall / std::max(largest / element_size(assembly_),
                                   first_.rightCols<3>().rowwise().norm().maxCoeff());
        const NodeValues second = response_to(quadratic_forces());
        const NodeValues third = response_to(cubic_forces(second));
        const auto u1 = first_.leftCols<3>();
        const double q = -u1.cwiseProduct(third.leftCols<3>()).sum() / u1.squaredNorm();
        const double left = q > 0.0 ? share_left(q) : 1.0;
        const double stiffer = q > 0.0 ? 1.0 / left - 1.0 : -q;
        range.error = std::hypot(stiffer, left * largest_translation(second) / largest);
        return range;
    }

  private:
    /// The solution x of x + q x^3 = 1, by Newton's method from above, which converges monotonically.
    static double share_left(double q) {
        double x = 1.0;
        for (int i = 0; i < 200; ++i) {
            const double step = (x + q * x * x * x - 1.0) / (1.0 + 3.0 * q * x * x);
            x -= step;
            if (step < 1e-12) break;
        }
        return x;
    }

    /// The internal forces at the state p u1 + p^2 u2.
    [[nodiscard]] NodeValues forces_at(double p, const NodeValues& second) const {
        return internal_forces(assembly_, p * first_ + p * p * second, options_.control);
    }

    [[nodiscard]] NodeValues quadratic_forces() const {
        const NodeValues none = NodeValues::Zero(first_.rows(), kDofsPerNode);
        return (forces_at(small_, none) + forces_at(-small_, none)) / (2.0 * small_ * small_);
    }

    /// The cubic forces, from the difference of two odd parts, which has no linear term.
    [[nodiscard]] NodeValues cubic_forces(const NodeValues& second) const {
        const auto odd = [&](double p) {
            return NodeValues((forces_at(p, second) - forces_at(-p, second)) / (2.0 * p));
        };
        return (odd(small_) - odd(0.5 * small_)) / (0.75 * small_ * small_);
    }

    [[nodiscard]] NodeValues response_to(const NodeValues& forces) const {
        const Eigen::VectorXd right_side = Eigen::Map<const Eigen::VectorXd>(forces.data(), forces.size());
        const Eigen::MatrixXd answer = solver_.solve_free(right_side, options_.control);
        NodeValues rows(forces.rows(), kDofsPerNode);
        Eigen::Map<Eigen::VectorXd>(rows.data(), rows.size()) = -answer.col(0);
        return rows;
    }

    /// The stability, judged by linearized buckling, because the linear state has strains that no real state
    /// has. A flat structure that is only bent has no forces in its plane and cannot buckle.
    [[nodiscard]] bool is_stable() const {
        constexpr double kNothing = 1e-9;
        const double in_plane = std::max(first_.leftCols<2>().cwiseAbs().maxCoeff(),
                                         first_.col(5).cwiseAbs().maxCoeff() * element_size(assembly_));
        const bool is_flat = std::ranges::all_of(
            assembly_.nodes, [&](const Eigen::Vector3d& node) { return node.z() == assembly_.nodes[0].z(); });
        if (is_flat && in_plane <= kNothing * largest_translation(first_)) return true;
        const auto modes = buckling_modes(assembly_, 1, {.control = options_.control});
        return modes.empty() || modes.front().value > 1.0;
    }

    const Assembly& assembly_;
    const LinearRangeOptions& options_;
    LinearSolver solver_;
    NodeValues first_;
    double small_ = 1.0;
};

}  // namespace

LinearRange linear_range(const Assembly& assembly, const LinearRangeOptions& options) {
    return PathTerms(assembly, options).range();
}

LinearPath linear_path(const Assembly& assembly, const LinearRangeOptions& options) {
    PathTerms terms(assembly, options);
    return {terms.range(), terms.first()};
}

}  // namespace fretwork::mechanics
