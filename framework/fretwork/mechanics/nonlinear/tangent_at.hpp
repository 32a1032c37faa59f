// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/nonlinear/mixed_newton.hpp>
#include <fretwork/mechanics/paths/equilibrium_tangent.hpp>

namespace fretwork::mechanics {

/// The implementation of EquilibriumTangent on the members of an EquilibriumSolver, which must outlive it.
class EquilibriumTangent::Impl {
  public:
    struct Parts {
        nonlinear::NonlinearSystem& system;
        nonlinear::Newton& newton;
        nonlinear::MixedNewton& mixed;
        EquilibriumOptions& options;  ///< options of `newton` and `mixed`; each call sets their control
        const nonlinear::Configuration& configuration;
        /// True if the factors belong to a tangent near that at the configuration, and so can refine
        /// solutions.
        bool& has_factors;
    };
    /// Evaluate the tangent. Throws NumericalError if the tangent is singular, and Stopped.
    Impl(const Parts& parts, const base::Control& control);

    [[nodiscard]] std::span<const NodeState> states() const { return parts_.configuration.states; }
    /// The steps of the unknowns under given forces, one column each. Throws NumericalError if the tangent is
    /// nearly singular, and Stopped.
    [[nodiscard]] Eigen::MatrixXd solve(const Eigen::MatrixXd& right_sides, nonlinear::Newton::Side side,
                                        const base::Control& control);
    [[nodiscard]] Eigen::MatrixXd equations_of(const Eigen::MatrixXd& rows) const;
    [[nodiscard]] Eigen::MatrixXd rows_of(const Eigen::MatrixXd& steps) const;
    /// Transform moments v, in place, to the quantities conjugate to rotation vectors, v <- T^T v. Only the
    /// rows of vector nodes are transformed (see Unknowns::vector_nodes()).
    void moments_to_vectors(Eigen::MatrixXd& rows) const;
    /// Transform rates v of the rotation vectors of vector nodes to spins, w = T v.
    void vectors_to_spins(Eigen::MatrixXd& rows) const;
    /// For all nodes except vector nodes, transform gradients with respect to rotation vectors to gradients
    /// along spins.
    void gradients_to_spins(Eigen::MatrixXd& rows) const;
    /// For all nodes, transform spins to rates of rotation vectors.
    void spins_to_vectors(Eigen::MatrixXd& rows) const;

    [[nodiscard]] Eigen::MatrixXd motions_of_held(const Eigen::MatrixXd& values,
                                                  const base::Control& control);
    [[nodiscard]] Eigen::MatrixXd by_held_values(const Eigen::MatrixXd& gradients,
                                                 const Eigen::MatrixXd& adjoint) const;
    [[nodiscard]] Eigen::MatrixXd strain_slopes(std::size_t element) const;
    [[nodiscard]] Eigen::VectorXd internal_forces(std::size_t element) const;
    [[nodiscard]] std::vector<Eigen::MatrixXd> flexibilities(std::span<const std::size_t> elements,
                                                             const base::Control& control);

  private:
    [[nodiscard]] const nonlinear::Unknowns& unknowns() const { return parts_.system.unknowns(); }
    [[nodiscard]] const Element& element(std::size_t index) const;
    [[nodiscard]] std::vector<NodeState> states_of(const Element& element) const;
    [[nodiscard]] Eigen::MatrixXd forces_of(const Element& element, const Eigen::MatrixXd& motions) const;
    [[nodiscard]] Eigen::MatrixXd forces_at_held(const Eigen::MatrixXd& motions,
                                                 nonlinear::Newton::Side side) const;
    void add_own_terms(const Eigen::MatrixXd& motions, nonlinear::Newton::Side side,
                       Eigen::MatrixXd& forces) const;
    [[nodiscard]] bool is_held(Eigen::Index node, int dof) const;
    void factorize(const base::Control& control);
    [[nodiscard]] Eigen::Index nodes() const;

    Parts parts_;
    bool is_exact_ = false;                   ///< true if the factors belong to the tangent
    std::vector<Eigen::Matrix3d> spin_maps_;  ///< spin map of every node's rotation vector
};

}  // namespace fretwork::mechanics
