// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/control.hpp>
#include <fretwork/mechanics/assembly.hpp>
#include <fretwork/mechanics/element.hpp>

#include <Eigen/Core>

#include <memory>
#include <span>
#include <vector>

namespace fretwork::mechanics {

/// The response of a structure to small changes at an equilibrium. It gives the derivatives of any function
/// of the nodes' displacements without another equilibrium.
///
/// Matrices have six rows for each node of the assembly, in the order of the nodes. *Motions* are
/// displacements (m) and spins (rad; R <- exp(w) R), *forces* are true forces and moments (N, N m).
/// *Gradients* are derivatives of a function J with respect to the displacements and rotation vectors of a
/// solution. Let T be the derivative, along motions, of the internal forces minus the applied forces. Then
///
///     motions = T^-1 forces,    adjoint motions l = T^-T gradient:  dJ = l . d(forces).
///
/// T is not symmetric if moments of fixed direction act. Held components do not move.
///
/// EquilibriumSolver creates an EquilibriumTangent at its last equilibrium and lends it the factors. It is
/// valid until the next solve() of that solver. Only one thread at a time may use it. Functions that solve
/// with T throw NumericalError if T is nearly singular.
class EquilibriumTangent {
  public:
    class Impl;
    /// Make the object from the solver's data; callers use EquilibriumSolver::tangent().
    explicit EquilibriumTangent(std::unique_ptr<Impl> impl);
    EquilibriumTangent(EquilibriumTangent&&) noexcept;
    EquilibriumTangent& operator=(EquilibriumTangent&&) noexcept;
    ~EquilibriumTangent();

    /// The states of all nodes at the equilibrium, the nodes between the elements of a beam included.
    [[nodiscard]] std::span<const NodeState> states() const;

    /// The motions under small forces, one column each. Throws Stopped.
    [[nodiscard]] Eigen::MatrixXd motions(const Eigen::MatrixXd& forces,
                                          const base::Control& control = {}) const;
    /// The motions if held components move by given values, one column each; rows of free components are
    /// ignored. Held rotation components are components of the rotation vector. Throws Stopped.
    [[nodiscard]] Eigen::MatrixXd motions_of_held(const Eigen::MatrixXd& values,
                                                  const base::Control& control = {}) const;
    /// The adjoint motions of gradients, one column each. Throws Stopped.
    [[nodiscard]] Eigen::MatrixXd adjoint_motions(const Eigen::MatrixXd& gradients,
                                                  const base::Control& control = {}) const;
    /// The derivatives of J with respect to the values of held components; zero for free components.
    /// @param adjoint_motions  the adjoint motions of the same gradients
    [[nodiscard]] Eigen::MatrixXd by_held_values(const Eigen::MatrixXd& gradients,
                                                 const Eigen::MatrixXd& adjoint_motions) const;

    /// Convert small motions to changes of displacements and rotation vectors.
    [[nodiscard]] Eigen::MatrixXd as_rotation_vectors(const Eigen::MatrixXd& motions) const;

    /// The slopes B = de/dx of an element's strains along motions of its nodes, stress_count() x 6n. Empty if
    /// the element has no stresses.
    [[nodiscard]] Eigen::MatrixXd strain_slopes(std::size_t element) const;
    /// The internal forces of an element on its nodes, 6n.
    [[nodiscard]] Eigen::VectorXd internal_forces(std::size_t element) const;
    /// For each of the given elements, the flexibility of the structure at its nodes, 6n x 6n: their motions
    /// under unit forces on them, by the symmetric part of T. One selected inversion computes all of them.
    /// Throws Stopped.
    [[nodiscard]] std::vector<Eigen::MatrixXd> flexibilities(std::span<const std::size_t> elements,
                                                             const base::Control& control = {}) const;

  private:
    std::unique_ptr<Impl> impl_;
};

}  // namespace fretwork::mechanics
