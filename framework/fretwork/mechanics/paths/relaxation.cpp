// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/task.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/mechanics/nonlinear/newton.hpp>
#include <fretwork/mechanics/paths/relaxation.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

namespace fretwork::mechanics {
namespace {

/// The ratio of masses to stiffness. With central differences, a unit time step is stable if masses exceed a
/// quarter of the stiffness, which changes on the way.
constexpr double kMassShare = 0.5;

/// @param against  the node relative to which the node turns; invalid: relative to its rest position
void refuse_turn(const Assembly& assembly, NodeIndex node, double angle, NodeIndex against = {}) {
    if (angle <= std::numbers::pi) return;
    throw base::InputError(
        structure::node_text(assembly, node) + " is prescribed to turn by " + base::format_number(angle) +
        " rad" + (against.is_valid() ? " against " + structure::node_text(assembly, against) : "") +
        ", and dynamic relaxation, which applies it in one jump, cannot follow more than pi; newton can");
}

/// Refuse prescribed rotations beyond pi, because the positions of the nodes alone cannot distinguish them
/// from rotations in the opposite sense.
void refuse_turns_beyond_pi(const Assembly& assembly) {
    Eigen::Matrix3Xd turns = Eigen::Matrix3Xd::Zero(3, static_cast<Eigen::Index>(assembly.nodes.size()));
    for (const PrescribedDisplacement& given : assembly.prescribed) {
        if (given.dof >= Dof::rx) turns(static_cast<int>(given.dof) - 3, given.node.value) = given.value;
    }
    for (const PrescribedDisplacement& given : assembly.prescribed)
        refuse_turn(assembly, given.node, turns.col(given.node.value).norm());
    for (const auto& element : assembly.elements) {
        for (const NodeIndex node : element->nodes()) {
            for (const NodeIndex other : element->nodes())
                refuse_turn(assembly, node, (turns.col(node.value) - turns.col(other.value)).norm(), other);
        }
    }
}

class Relaxation {
  public:
    Relaxation(const Assembly& assembly, const RelaxationOptions& options)
        : options_(options), system_(assembly, 1, options.control), configuration_(unknowns_.rest()) {
        unknowns_.prescribe(1.0, configuration_);
        last_peak_ = configuration_;
        velocity_.setZero(unknowns_.equations());
        system_.evaluate(configuration_, 1.0);
        weigh();
    }

    Solution run() {
        const base::Task task(options_.control, "dynamic relaxation (iterations)", options_.iterations);
        double last_energy = 0.0;
        Termination termination = Termination::IterationsSpent;
        int iteration = 0;
        for (; iteration < options_.iterations; ++iteration) {
            options_.control.check();
            task.update(iteration);
            if (!std::isfinite(system_.relative_residual())) {
                termination = Termination::Diverged;
                break;
            }
            if (system_.relative_residual() <= options_.relative_residual) {
                termination = Termination::Converged;
                break;
            }
            accelerate();
            const double energy = velocity_.cwiseAbs2().dot(mass_);
            if (energy < last_energy) {
                restart();
                last_energy = 0.0;
                continue;
            }
            last_energy = energy;
            unknowns_.move(velocity_, configuration_);
            system_.evaluate(configuration_, 1.0, Demand::Force);
        }
        return finish(termination, iteration);
    }

  private:
    /// Update the velocities, which belong to the middles of the steps; from rest, the first velocity follows
    /// after half a step.
    void accelerate() {
        last_velocity_ = velocity_;
        velocity_ += (is_at_rest_ ? 0.5 : 1.0) * system_.unbalanced().cwiseQuotient(mass_);
        is_at_rest_ = false;
    }

    /// Restart from rest at the peak of the kinetic energy, which lies in the middle of the last step, with
    /// masses computed again.
    void restart() {
        unknowns_.move(-0.5 * last_velocity_, configuration_);
        last_peak_ = configuration_;
        velocity_.setZero();
        is_at_rest_ = true;
        system_.evaluate(configuration_, 1.0);
        weigh();
    }

    /// Set the masses by Gershgorin's bound of the stiffness, in units in which displacements and rotations
    /// are comparable.
    void weigh() {
        const Eigen::VectorXd scale = unknowns_.weights().cwiseSqrt();
        const auto& start = unknowns_.layout().column_start();
        const auto& row = unknowns_.layout().row();
        mass_.setZero(unknowns_.equations());
        for (int column = 0; column < unknowns_.equations(); ++column) {
            for (int k = start[column]; k < start[column + 1]; ++k) {
                const int i = row[k];
                const double entry = std::abs(system_.tangent()[k]);
                mass_[i] += entry * scale[i] / scale[column];
                if (i != column) mass_[column] += entry * scale[column] / scale[i];
            }
        }
        mass_ *= kMassShare;
        if (options_.rotational_mass == RotationalMass::Published) weigh_rotations_as_published();
        for (int node = 0; node < static_cast<int>(unknowns_.assembly().nodes.size()); ++node) {
            make_isotropic(node, 0);
            make_isotropic(node, 3);
        }
    }

    void weigh_rotations_as_published() {
        const double length = structure::characteristic_length(unknowns_.assembly());
        const double per_square_metre = std::max(1.0, 1.0 / (length * length));
        for (int node = 0; node < static_cast<int>(unknowns_.assembly().nodes.size()); ++node) {
            for (int d = 3; d < kDofsPerNode; ++d) {
                const int equation = unknowns_.layout().equation(node, d);
                if (equation >= 0) mass_[equation] *= per_square_metre;
            }
        }
    }

    /// Give all three directions of a node one mass, because the directions in which the node is stiff turn
    /// with the structure.
    void make_isotropic(int node, int first_dof) {
        double largest = 0.0;
        for (int d = first_dof; d < first_dof + 3; ++d) {
            const int equation = unknowns_.layout().equation(node, d);
            if (equation >= 0) largest = std::max(largest, mass_[equation]);
        }
        for (int d = first_dof; d < first_dof + 3; ++d) {
            const int equation = unknowns_.layout().equation(node, d);
            if (equation >= 0) mass_[equation] = largest;
        }
    }

    /// True if the last evaluation, which computed the tangent, gave finite numbers. Forces between held
    /// nodes are seen only in the reactions.
    [[nodiscard]] bool is_finite(double load_factor) const {
        const auto is_number = [](double value) { return std::isfinite(value); };
        const Solution found = system_.describe(configuration_, load_factor);
        return is_number(system_.relative_residual()) && is_number(found.energy) &&
               found.reactions.allFinite() && std::ranges::all_of(system_.tangent(), is_number);
    }

    /// Evaluate the configuration under the full load, with the rotation vectors that a solution has.
    void evaluate_end() {
        nonlinear::continue_along_elements(unknowns_, configuration_);
        system_.evaluate(configuration_, 1.0);
    }

    /// Go back to the last peak, or to rest without load if that is not finite either: prescribed
    /// displacements may leave no finite state to begin at. Returns the load factor.
    double go_back() {
        configuration_ = last_peak_;
        evaluate_end();
        if (is_finite(1.0)) return 1.0;
        configuration_ = unknowns_.rest();
        system_.evaluate(configuration_, 0.0);
        return 0.0;
    }

    [[nodiscard]] Solution finish(Termination termination, int iterations) {
        double load_factor = 1.0;
        evaluate_end();
        if (!is_finite(load_factor)) {
            termination = Termination::Diverged;
            load_factor = go_back();
        }
        Solution solution = system_.describe(configuration_, load_factor);
        solution.termination = termination;
        solution.iterations = iterations;
        sparse::Ldlt factors(unknowns_.layout());
        solution.stable = factors.factorize(system_.tangent()).positive_definite();
        solution.stability = system_.stability_test();
        return solution;
    }

    const RelaxationOptions& options_;
    nonlinear::NonlinearSystem system_;
    const nonlinear::Unknowns& unknowns_ = system_.unknowns();
    nonlinear::Configuration configuration_;
    /// Configuration at the last peak of the kinetic energy, or at the start; returned, if it is finite, when
    /// relaxation diverges.
    nonlinear::Configuration last_peak_;
    Eigen::VectorXd velocity_;
    Eigen::VectorXd last_velocity_;
    bool is_at_rest_ = true;
    Eigen::VectorXd mass_;
};

}  // namespace

void RelaxationOptions::validate() const {
    if (!(relative_residual > 0.0 && relative_residual < 1.0))
        throw base::InputError("relative_residual must be in (0, 1)");
    if (iterations < 1) throw base::InputError("iterations must be above zero");
}

Solution relax(const Assembly& assembly, const RelaxationOptions& options) {
    options.validate();
    refuse_turns_beyond_pi(assembly);
    return Relaxation(assembly, options).run();
}

}  // namespace fretwork::mechanics
