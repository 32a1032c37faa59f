// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/parallel.hpp>
#include <fretwork/mechanics/linear_solver.hpp>
#include <fretwork/mechanics/sparse/ldlt.hpp>
#include <fretwork/mechanics/structure/constraints.hpp>
#include <fretwork/mechanics/structure/coupling.hpp>
#include <fretwork/mechanics/structure/mechanism.hpp>
#include <fretwork/mechanics/structure/plane_split.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace fretwork::mechanics {
namespace {

using sparse::Ldlt;
using sparse::SystemLayout;
using structure::kInPlane;
using structure::kOutOfPlane;

/// One refinement is made where the first solution is less accurate than this. Below it, what is left is the
/// rounding of the stiffness itself, and refinement only exchanges one error for another.
constexpr double kGoodResidual = 1e-9;

/// A stiffness entry in the row of a held dof.
struct HeldEntry {
    int node, dof, other_node, other_dof;
    double value;
};

/// Equations that can be solved on their own: all of a structure, or its half in or out of the plane.
struct Subsystem {
    Subsystem(SystemLayout equations, int threads)
        : layout(std::make_unique<SystemLayout>(std::move(equations))),
          values(layout->row().size(), 0.0),
          factors(*layout, threads) {}
    std::unique_ptr<SystemLayout> layout;
    std::vector<double> values;
    Ldlt factors;
    // Of the solve at hand.
    Eigen::VectorXd displacements;
    Eigen::VectorXd unbalanced;  ///< loads less internal forces
    Eigen::VectorXd internal;
};

}  // namespace

class LinearSolver::Impl {
  public:
    Impl(const Assembly& assembly, const LinearOptions& options)
        : threads_(base::resolved_thread_count(options.threads)) {
        build(assembly);
    }

    void refactorize(const Assembly& assembly) {
        constraints_ = structure::constraints_of(assembly);
        loads_ = assembly.loads;
        if (!assemble(assembly)) return build(assembly);  // what was flat is not any more
        factorize(assembly);
    }

    [[nodiscard]] const NodeValues& own_loads() const { return loads_; }

    [[nodiscard]] Solution solve(const NodeValues& loads) {
        Solution solution;
        NodeValues displacements = constraints_.values;
        start(loads, displacements);
        NodeValues unbalanced;
        for (int pass = 0; pass < 2; ++pass) {
            correct(displacements);
            unbalanced = out_of_balance(loads, displacements);
            ++solution.iterations;
            solution.residual = relative_residual(loads, unbalanced);
            if (solution.residual < kGoodResidual) break;
        }
        finish(loads, displacements, unbalanced, solution);
        return solution;
    }

  private:
    void build(const Assembly& assembly) {
        constraints_ = structure::constraints_of(assembly);
        loads_ = assembly.loads;
        reported_ = assembly.reported_nodes;
        length_ = structure::characteristic_length(assembly);
        const sparse::NodeGraph graph = structure::coupling_graph(assembly);
        const std::vector<int> order =
            sparse::elimination_order(graph, structure::other_components(constraints_.held));
        if (!planar_refused_ && structure::is_flat(assembly)) {
            lay_out(graph, order, {kInPlane, kOutOfPlane});
            if (assemble(assembly)) return factorize(assembly);
            planar_refused_ = true;
        }
        lay_out(graph, order, {DofSet::all()});
        assemble(assembly);
        factorize(assembly);
    }

    void lay_out(const sparse::NodeGraph& graph, const std::vector<int>& order,
                 const std::vector<DofSet>& parts) {
        systems_.clear();
        for (const DofSet& part : parts) {
            std::vector<sparse::Components> free = structure::other_components(constraints_.held);
            for (sparse::Components& components : free) {
                for (std::size_t d = 0; d < kDofsPerNode; ++d)
                    components[d] = components[d] && part.contains[d];
            }
            SystemLayout layout(graph, free, order);
            if (layout.equations() > 0) systems_.emplace_back(std::move(layout), threads_);
        }
        split_ = parts.size() > 1;
    }

    /// False if an element couples what was to be solved apart.
    bool assemble(const Assembly& assembly) {
        for (Subsystem& system : systems_) std::fill(system.values.begin(), system.values.end(), 0.0);
        held_entries_.clear();
        Eigen::MatrixXd stiffness;
        for (std::size_t e = 0; e < assembly.elements.size(); ++e) {
            const Element& element = *assembly.elements[e];
            element.rest_stiffness(stiffness);
            if (split_ && !structure::decouples(stiffness)) return false;
            for (Subsystem& system : systems_) system.layout->add(e, stiffness, system.values);
            keep_held_rows(element.nodes(), stiffness);
        }
        return true;
    }

    void keep_held_rows(std::span<const NodeIndex> nodes, const Eigen::MatrixXd& stiffness) {
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            const DofSet& held = constraints_.held[static_cast<std::size_t>(nodes[i].value)];
            if (held == DofSet{}) continue;
            for (int d = 0; d < kDofsPerNode; ++d) {
                if (held.contains[static_cast<std::size_t>(d)])
                    keep_row(nodes, static_cast<Eigen::Index>(i) * kDofsPerNode + d, stiffness);
            }
        }
    }

    void keep_row(std::span<const NodeIndex> nodes, Eigen::Index row, const Eigen::MatrixXd& stiffness) {
        const int node = nodes[static_cast<std::size_t>(row / kDofsPerNode)].value;
        const int dof = static_cast<int>(row % kDofsPerNode);
        for (Eigen::Index j = 0; j < stiffness.cols(); ++j) {
            if (stiffness(row, j) == 0.0) continue;
            const int other = nodes[static_cast<std::size_t>(j / kDofsPerNode)].value;
            held_entries_.push_back(
                {node, dof, other, static_cast<int>(j % kDofsPerNode), stiffness(row, j)});
        }
    }

    void factorize(const Assembly& assembly) {
        for (Subsystem& system : systems_) {
            const Ldlt::Outcome outcome = system.factors.factorize(system.values);
            structure::refuse_mechanisms(assembly, *system.layout, system.values, system.factors, outcome);
        }
    }

    /// Call body for each of the systems. They share no equation, so the result is that of one thread.
    template <class Body>
    void for_each_system(const Body& body) {
        constexpr int kManyEquations = 3000;
        const bool many = !systems_.empty() && systems_.front().layout->equations() > kManyEquations;
        base::parallel_for(systems_.size(), many ? threads_ : 1, [&](std::size_t i) { body(systems_[i]); });
    }

    /// All free dofs at rest, the held ones where they are to be.
    void start(const NodeValues& loads, const NodeValues& displacements) {
        for_each_system([&](Subsystem& system) {
            system.layout->gather(loads, system.unbalanced);
            system.displacements.setZero(system.unbalanced.size());
        });
        if (!constraints_.values.isZero(0.0)) (void)out_of_balance(loads, displacements);
    }

    /// Loads less internal forces, those of the free dofs in the systems, too. At held dofs that is
    /// the negative reaction.
    [[nodiscard]] NodeValues out_of_balance(const NodeValues& loads, const NodeValues& displacements) {
        NodeValues result = loads;
        for (const HeldEntry& entry : held_entries_) {
            result(entry.node, entry.dof) -= entry.value * displacements(entry.other_node, entry.other_dof);
            if (!is_held(entry.other_node, entry.other_dof))
                result(entry.other_node, entry.other_dof) -=
                    entry.value * displacements(entry.node, entry.dof);
        }
        for_each_system([&](Subsystem& system) {
            system.layout->gather(result, system.unbalanced);
            system.internal.setZero(system.displacements.size());
            sparse::add_product(*system.layout, system.values, system.displacements, system.internal);
            system.unbalanced -= system.internal;
            system.layout->scatter(system.unbalanced, result);
        });
        return result;
    }

    [[nodiscard]] bool is_held(int node, int dof) const {
        return constraints_.held[static_cast<std::size_t>(node)].contains[static_cast<std::size_t>(dof)];
    }

    void correct(NodeValues& displacements) {
        for_each_system([&](Subsystem& system) {
            if (system.unbalanced.isZero(0.0)) return;  // loaded in its plane only, or across it
            system.factors.solve(system.unbalanced);
            system.displacements += system.unbalanced;
            system.layout->scatter(system.displacements, displacements);
        });
    }

    /// Keep the held rows, negated, or the others.
    [[nodiscard]] NodeValues reactions_of(const NodeValues& unbalanced) const {
        NodeValues reactions = NodeValues::Zero(unbalanced.rows(), kDofsPerNode);
        for (int node = 0; node < static_cast<int>(unbalanced.rows()); ++node) {
            for (int d = 0; d < kDofsPerNode; ++d) {
                if (is_held(node, d)) reactions(node, d) = -unbalanced(node, d);
            }
        }
        return reactions;
    }

    /// The out-of-balance forces of the free dofs; those of the held ones are the reactions.
    [[nodiscard]] double relative_residual(const NodeValues& loads, const NodeValues& unbalanced) const {
        double free = 0.0;
        double held = 0.0;
        for (int node = 0; node < static_cast<int>(unbalanced.rows()); ++node) {
            for (int d = 0; d < kDofsPerNode; ++d) {
                const double force = unbalanced(node, d) / (d < 3 ? 1.0 : length_);
                (is_held(node, d) ? held : free) += force * force;
            }
        }
        const double scale = structure::force_norm(loads, length_) + std::sqrt(held);
        return scale > 0 ? std::sqrt(free) / scale : 0.0;
    }

    void finish(const NodeValues& loads, const NodeValues& displacements, const NodeValues& unbalanced,
                Solution& solution) const {
        const NodeValues reactions = reactions_of(unbalanced);
        solution.energy = 0.5 * (loads + reactions).cwiseProduct(displacements).sum();
        solution.displacements = displacements.topRows(reported_);
        solution.inner_displacements = displacements.bottomRows(displacements.rows() - reported_);
        solution.reactions = reactions.topRows(reported_);
    }

    int threads_;
    structure::Constraints constraints_;
    NodeValues loads_;
    int reported_ = 0;
    double length_ = 1.0;
    bool split_ = false;
    bool planar_refused_ = false;
    std::vector<Subsystem> systems_;
    std::vector<HeldEntry> held_entries_;
};

LinearSolver::LinearSolver(const Assembly& assembly, const LinearOptions& options)
    : impl_(std::make_unique<Impl>(assembly, options)) {}
LinearSolver::LinearSolver(LinearSolver&&) noexcept = default;
LinearSolver& LinearSolver::operator=(LinearSolver&&) noexcept = default;
LinearSolver::~LinearSolver() = default;

Solution LinearSolver::solve() const {
    return impl_->solve(impl_->own_loads());
}

Solution LinearSolver::solve(const NodeValues& loads) const {
    return impl_->solve(loads);
}

void LinearSolver::refactorize(const Assembly& assembly) {
    impl_->refactorize(assembly);
}

Solution solve_linear(const Assembly& assembly, const LinearOptions& options) {
    return LinearSolver(assembly, options).solve();
}

}  // namespace fretwork::mechanics
