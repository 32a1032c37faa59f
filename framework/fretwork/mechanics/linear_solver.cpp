// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/parallel.hpp>
#include <fretwork/mechanics/linear_solver.hpp>
#include <fretwork/mechanics/structure/factorized_structure.hpp>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <vector>

namespace fretwork::mechanics {
namespace {

using structure::FactorizedStructure;
using structure::Subsystem;

/// One refinement is made where the first solution is less accurate than this. Below it, what is left is the
/// rounding of the stiffness itself, and refinement only exchanges one error for another.
constexpr double kGoodResidual = 1e-9;

/// One subsystem of a solve at hand.
struct Iterate {
    const Subsystem* system;
    Eigen::VectorXd displacements{};
    Eigen::VectorXd unbalanced{};  ///< loads less internal forces
};

}  // namespace

class LinearSolver::Impl {
  public:
    explicit Impl(FactorizedStructure structure)
        : structure_(std::move(structure)),
          length_(structure::characteristic_length(structure_.assembly())) {}

    [[nodiscard]] const FactorizedStructure& structure() const { return structure_; }

    [[nodiscard]] Solution solve(const NodeValues& loads) const {
        Solution solution;
        NodeValues displacements = structure_.constraints().values;
        std::vector<Iterate> iterates = start(loads, displacements);
        NodeValues unbalanced;
        const int least_passes = structure_.corrected_elements() > 0 ? 2 : 1;
        for (int pass = 1; pass <= 2; ++pass) {
            correct(iterates, displacements);
            unbalanced = out_of_balance(loads, displacements, iterates);
            ++solution.iterations;
            solution.residual = relative_residual(loads, unbalanced);
            if (pass >= least_passes && solution.residual < kGoodResidual) break;
        }
        finish(loads, displacements, unbalanced, solution);
        return solution;
    }

    [[nodiscard]] Eigen::MatrixXd solve_free(const Eigen::MatrixXd& right_sides) const {
        assert(right_sides.rows() == std::ssize(structure_.assembly().nodes) * kDofsPerNode);
        Eigen::MatrixXd result = Eigen::MatrixXd::Zero(right_sides.rows(), right_sides.cols());
        for_each(structure_.systems(), [&](const Subsystem& system) {
            const std::vector<int> rows = rows_of(system);
            const Eigen::MatrixXd loads = right_sides(rows, Eigen::all);
            Eigen::MatrixXd x = loads;
            system.solve(x);
            Eigen::MatrixXd unbalanced = loads;
            for (Eigen::Index c = 0; c < x.cols(); ++c) unbalanced.col(c) -= system.internal_forces(x.col(c));
            system.solve(unbalanced);
            result(rows, Eigen::all) = x + unbalanced;
        });
        return result;
    }

  private:
    /// Call body for each of the systems, or what belongs to one. They share no equation, so the result is
    /// that of one thread.
    template <class List, class Body>
    void for_each(List&& list, const Body& body) const {
        constexpr int kManyEquations = 3000;
        const auto systems = structure_.systems();
        const bool many = !systems.empty() && systems.front().layout().equations() > kManyEquations;
        base::parallel_for(list.size(), many ? structure_.threads() : 1,
                           [&](std::size_t i) { body(list[i]); });
    }

    /// For each equation the row of its dof in a column of 6 rows a node.
    [[nodiscard]] std::vector<int> rows_of(const Subsystem& system) const {
        std::vector<int> rows(static_cast<std::size_t>(system.layout().equations()));
        for (int node = 0; node < static_cast<int>(structure_.assembly().nodes.size()); ++node) {
            for (int d = 0; d < kDofsPerNode; ++d) {
                const int equation = system.layout().equation(node, d);
                if (equation >= 0) rows[static_cast<std::size_t>(equation)] = node * kDofsPerNode + d;
            }
        }
        return rows;
    }

    /// All free dofs at rest, the held ones where they are to be.
    [[nodiscard]] std::vector<Iterate> start(const NodeValues& loads, const NodeValues& displacements) const {
        std::vector<Iterate> iterates;
        for (const Subsystem& system : structure_.systems()) iterates.push_back({&system});
        for_each(iterates, [&](Iterate& iterate) {
            iterate.system->layout().gather(loads, iterate.unbalanced);
            iterate.displacements.setZero(iterate.unbalanced.size());
        });
        if (!structure_.constraints().values.isZero(0.0))
            (void)out_of_balance(loads, displacements, iterates);
        return iterates;
    }

    /// Loads less internal forces, those of the free dofs in the iterates, too. At held dofs that is
    /// the negative reaction.
    [[nodiscard]] NodeValues out_of_balance(const NodeValues& loads, const NodeValues& displacements,
                                            std::vector<Iterate>& iterates) const {
        NodeValues result = loads;
        for (const structure::HeldEntry& entry : structure_.held_entries()) {
            result(entry.node, entry.dof) -= entry.value * displacements(entry.other_node, entry.other_dof);
            if (!is_held(entry.other_node, entry.other_dof))
                result(entry.other_node, entry.other_dof) -=
                    entry.value * displacements(entry.node, entry.dof);
        }
        for_each(iterates, [&](Iterate& iterate) {
            iterate.system->layout().gather(result, iterate.unbalanced);
            iterate.unbalanced -= iterate.system->internal_forces(iterate.displacements);
            iterate.system->layout().scatter(iterate.unbalanced, result);
        });
        return result;
    }

    [[nodiscard]] bool is_held(int node, int dof) const {
        return structure_.constraints()
            .held[static_cast<std::size_t>(node)]
            .contains[static_cast<std::size_t>(dof)];
    }

    void correct(std::vector<Iterate>& iterates, NodeValues& displacements) const {
        for_each(iterates, [&](Iterate& iterate) {
            if (iterate.unbalanced.isZero(0.0)) return;  // loaded in its plane only, or across it
            iterate.system->solve(iterate.unbalanced);
            iterate.displacements += iterate.unbalanced;
            iterate.system->layout().scatter(iterate.displacements, displacements);
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
        const int reported = structure_.assembly().reported_nodes;
        solution.displacements = displacements.topRows(reported);
        solution.inner_displacements = displacements.bottomRows(displacements.rows() - reported);
        solution.reactions = reactions.topRows(reported);
    }

    FactorizedStructure structure_;
    double length_;  ///< makes moments comparable to forces
};

LinearSolver::LinearSolver(const Assembly& assembly, const LinearOptions& options)
    : impl_(std::make_unique<Impl>(FactorizedStructure(assembly, options.threads))) {}
LinearSolver::LinearSolver(LinearSolver&&) noexcept = default;
LinearSolver& LinearSolver::operator=(LinearSolver&&) noexcept = default;
LinearSolver::~LinearSolver() = default;

Solution LinearSolver::solve() const {
    return impl_->solve(impl_->structure().assembly().loads);
}

Solution LinearSolver::solve(const NodeValues& loads) const {
    return impl_->solve(loads);
}

Eigen::MatrixXd LinearSolver::solve_free(const Eigen::MatrixXd& right_sides) const {
    return impl_->solve_free(right_sides);
}

FactorChange LinearSolver::update(const Assembly& assembly) {
    impl_ = std::make_unique<Impl>(FactorizedStructure(impl_->structure(), assembly));
    return impl_->structure().last_change();
}

Solution solve_linear(const Assembly& assembly, const LinearOptions& options) {
    return LinearSolver(assembly, options).solve();
}

}  // namespace fretwork::mechanics
