// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/parallel.hpp>
#include <fretwork/mechanics/linear_solver.hpp>
#include <fretwork/mechanics/structure/factorized_structure.hpp>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <vector>

namespace fretwork::mechanics {
namespace {

using structure::FactorizedStructure;
using structure::Subsystem;

/// A solution is refined until its residual is below kGoodResidual, but at most kMostRefinements times, and
/// only as long as each refinement at least halves the residual.
constexpr double kGoodResidual = 1e-9;
constexpr int kMostRefinements = 3;

/// The largest residual that rounding of the displacements explains, as a share of the forces that cancel at
/// the nodes.
constexpr double kRoundingShare = 8.0 * std::numeric_limits<double>::epsilon();
/// In a structure without loads, rounding explains all forces if its estimate is at least this share of them.
constexpr double kRigidShare = 0.1;
/// The largest residual of a converged solution. The error of the reactions is about the residual.
constexpr double kLargestResidual = 1e-4;

/// One subsystem in a solution.
struct Part {
    const Subsystem* system;
    Eigen::VectorXd displacements{};
    Eigen::VectorXd unbalanced{};  ///< loads minus internal forces
};

/// An iterate of a solution.
struct Iterate {
    std::vector<Part> parts;
    NodeValues displacements;
    NodeValues unbalanced{};  ///< loads minus internal forces; the negative reactions at held dofs
    double residual = std::numeric_limits<double>::infinity();
};

}  // namespace

class LinearSolver::Impl {
  public:
    explicit Impl(FactorizedStructure structure)
        : structure_(std::move(structure)),
          length_(structure::characteristic_length(structure_.assembly())) {}

    [[nodiscard]] const FactorizedStructure& structure() const { return structure_; }

    [[nodiscard]] Solution solve(const NodeValues& loads, const base::Control& control) const {
        Solution solution;
        // The first refinement restores the accuracy that corrected factors lose.
        const int least_refinements = structure_.corrected_elements() > 0 ? 1 : 0;
        Iterate best = refined(start(loads), loads, control);
        bool helps = true;
        solution.iterations = 1;
        for (int refinement = 1; refinement <= kMostRefinements; ++refinement) {
            const bool is_needed = refinement <= least_refinements;
            if (!is_needed && !(helps && best.residual >= kGoodResidual)) break;
            Iterate next = refined(best, loads, control);
            ++solution.iterations;
            if (!(next.residual < best.residual)) break;
            helps = is_needed || next.residual < 0.5 * best.residual;
            best = std::move(next);
        }
        finish(loads, best, solution);
        judge(loads, best, solution);
        return solution;
    }

    [[nodiscard]] Eigen::MatrixXd solve_free(const Eigen::MatrixXd& right_sides,
                                             const base::Control& control) const {
        assert(right_sides.rows() == std::ssize(structure_.assembly().nodes) * kDofsPerNode);
        Eigen::MatrixXd result = Eigen::MatrixXd::Zero(right_sides.rows(), right_sides.cols());
        for_each(structure_.systems(), [&](const Subsystem& system) {
            const std::vector<int> rows = rows_of(system);
            const Eigen::MatrixXd loads = right_sides(rows, Eigen::all);
            Eigen::MatrixXd x = loads;
            system.solve(x, control);
            Eigen::MatrixXd unbalanced = loads;
            for (Eigen::Index c = 0; c < x.cols(); ++c) {
                control.check();
                unbalanced.col(c) -= system.internal_forces(x.col(c));
            }
            system.solve(unbalanced, control);
            result(rows, Eigen::all) = x + unbalanced;
        });
        if (!result.allFinite())
            throw base::NumericalError(
                "the displacements under these right sides are too large for a number");
        return result;
    }

  private:
    /// Call body for each entry of a list with one entry for each system. Systems share no equation, so the
    /// result does not depend on the number of threads.
    template <class List, class Body>
    void for_each(List&& list, const Body& body) const {
        constexpr int kManyEquations = 3000;
        const auto systems = structure_.systems();
        const bool many = !systems.empty() && systems.front().layout().equations() > kManyEquations;
        base::parallel_for(list.size(), many ? structure_.threads() : 1,
                           [&](std::size_t i) { body(list[i]); });
    }

    /// For each equation, the row of its dof in a column with 6 rows for each node.
    [[nodiscard]] std::vector<int> rows_of(const Subsystem& system) const {
        std::vector<int> rows(static_cast<std::size_t>(system.layout().equations()));
        for (int node = 0; node < static_cast<int>(structure_.assembly().nodes.size()); ++node) {
            for (int d = 0; d < kDofsPerNode; ++d) {
                const int equation = system.layout().equation(node, d);
                if (equation >= 0) rows[equation] = node * kDofsPerNode + d;
            }
        }
        return rows;
    }

    /// The first iterate: free dofs at rest, held dofs at their values.
    [[nodiscard]] Iterate start(const NodeValues& loads) const {
        Iterate iterate;
        iterate.displacements = structure_.constraints().values;
        for (const Subsystem& system : structure_.systems()) iterate.parts.push_back({&system});
        for_each(iterate.parts, [&](Part& part) {
            part.system->layout().gather(loads, part.unbalanced);
            part.displacements.setZero(part.unbalanced.size());
        });
        if (!structure_.constraints().values.isZero(0.0)) balance(iterate, loads);
        return iterate;
    }

    /// The next iterate, corrected for the unbalanced forces of the last one.
    [[nodiscard]] Iterate refined(Iterate iterate, const NodeValues& loads,
                                  const base::Control& control) const {
        for_each(iterate.parts, [&](Part& part) {
            // A flat structure may be loaded only in its plane, or only across it.
            if (part.unbalanced.isZero(0.0)) return;
            part.system->solve(part.unbalanced, control);
            part.displacements += part.unbalanced;
            part.system->layout().scatter(part.displacements, iterate.displacements);
        });
        control.check();
        balance(iterate, loads);
        iterate.residual = relative_residual(loads, iterate.unbalanced);
        return iterate;
    }

    /// Compute the loads minus the internal forces.
    void balance(Iterate& iterate, const NodeValues& loads) const {
        iterate.unbalanced = loads;
        NodeValues& forces = iterate.unbalanced;
        const NodeValues& displacements = iterate.displacements;
        for (const structure::HeldEntry& entry : structure_.held_entries()) {
            forces(entry.node, entry.dof) -= entry.value * displacements(entry.other_node, entry.other_dof);
            if (!is_held(entry.other_node, entry.other_dof))
                forces(entry.other_node, entry.other_dof) -=
                    entry.value * displacements(entry.node, entry.dof);
        }
        for_each(iterate.parts, [&](Part& part) {
            part.system->layout().gather(forces, part.unbalanced);
            part.unbalanced -= part.system->internal_forces(part.displacements);
            part.system->layout().scatter(part.unbalanced, forces);
        });
    }

    [[nodiscard]] bool is_held(int node, int dof) const {
        return structure_.constraints().held[node].contains[dof];
    }

    /// The reactions: the negative unbalanced forces at held dofs, zero at free dofs.
    [[nodiscard]] NodeValues reactions_of(const NodeValues& unbalanced) const {
        NodeValues reactions = NodeValues::Zero(unbalanced.rows(), kDofsPerNode);
        for (int node = 0; node < static_cast<int>(unbalanced.rows()); ++node) {
            for (int d = 0; d < kDofsPerNode; ++d) {
                if (is_held(node, d)) reactions(node, d) = -unbalanced(node, d);
            }
        }
        return reactions;
    }

    /// The norm of the unbalanced forces at free dofs, over the norm of loads and reactions (the unbalanced
    /// forces at held dofs).
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

    /// The forces that cancel at the free dofs, |K| |d| + |F|, relative to the scale of the residual.
    [[nodiscard]] double relative_cancellation(const NodeValues& loads, const Iterate& iterate,
                                               double scale) const {
        NodeValues forces = loads.cwiseAbs();
        for (const Part& part : iterate.parts) {
            Eigen::VectorXd own;
            part.system->layout().gather(forces, own);
            own += part.system->cancelling_forces(part.displacements);
            part.system->layout().scatter(own, forces);
        }
        return scale > 0.0 ? structure::force_norm(forces, length_) / scale : 0.0;
    }

    void judge(const NodeValues& loads, const Iterate& iterate, Solution& solution) const {
        solution.residual = iterate.residual;
        if (!std::isfinite(solution.displacements.norm()) || !std::isfinite(solution.energy) ||
            !std::isfinite(solution.residual))
            throw base::NumericalError(
                "the displacements under this load are too large for a number: lengths, stiffnesses or loads "
                "differ too much in size");
        if (solution.residual < kGoodResidual) return;
        const double scale =
            structure::force_norm(loads, length_) + structure::force_norm(solution.reactions, length_);
        const double rounding = kRoundingShare * relative_cancellation(loads, iterate, scale);
        // Supports that move a structure as a rigid body cause no forces, so all forces are rounding.
        if (loads.isZero(0.0) && rounding >= kRigidShare) {
            solution.residual = 0.0;
            return;
        }
        if (solution.residual > std::min(rounding, kLargestResidual))
            solution.termination = Termination::IterationsSpent;
    }

    void finish(const NodeValues& loads, const Iterate& iterate, Solution& solution) const {
        const NodeValues reactions = reactions_of(iterate.unbalanced);
        const NodeValues& displacements = iterate.displacements;
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
    : impl_(std::make_unique<Impl>(FactorizedStructure(assembly, options))) {}
LinearSolver::LinearSolver(LinearSolver&&) noexcept = default;
LinearSolver& LinearSolver::operator=(LinearSolver&&) noexcept = default;
LinearSolver::~LinearSolver() = default;

Solution LinearSolver::solve(const base::Control& control) const {
    return impl_->solve(impl_->structure().assembly().loads, control);
}

Solution LinearSolver::solve(const NodeValues& loads, const base::Control& control) const {
    return impl_->solve(loads, control);
}

Eigen::MatrixXd LinearSolver::solve_free(const Eigen::MatrixXd& right_sides,
                                         const base::Control& control) const {
    return impl_->solve_free(right_sides, control);
}

FactorChange LinearSolver::update(const Assembly& assembly, const base::Control& control) {
    impl_ = std::make_unique<Impl>(
        FactorizedStructure(impl_->structure(), assembly, structure::ElementEdit::Cheaper, control));
    return impl_->structure().last_change();
}

Solution solve_linear(const Assembly& assembly, const LinearOptions& options) {
    return LinearSolver(assembly, options).solve(options.control.silent());
}

}  // namespace fretwork::mechanics
