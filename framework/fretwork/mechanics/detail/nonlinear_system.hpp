// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/assembly.hpp>
#include <fretwork/mechanics/detail/constraints.hpp>
#include <fretwork/mechanics/detail/ldlt.hpp>
#include <fretwork/mechanics/detail/system_layout.hpp>
#include <fretwork/mechanics/solution.hpp>

#include <vector>

namespace fretwork::mechanics::detail {

/// Where all nodes are: their rotations as rotations, and as rotation vectors that follow the path without
/// jumps.
struct Configuration {
    std::vector<NodeState> states;
    std::vector<Eigen::Vector3d> rotation_vectors;
};

/// The equations of nonlinear equilibrium, internal = load factor * loads, and their derivative.
///
/// The rotational unknowns of a node that turns freely are spins. Where supports hold some components of the
/// total rotation vector, the unknowns are the others, and moments and tangent are transformed to them. The
/// tangent is a symmetric matrix and, at freely turning nodes with applied moments of fixed direction, small
/// skew blocks.
class NonlinearSystem {
  public:
    /// @param threads  that evaluate the elements where these are many; 0: all there are
    explicit NonlinearSystem(const Assembly& assembly, int threads = 1);

    [[nodiscard]] const SystemLayout& layout() const { return *layout_; }
    [[nodiscard]] const Assembly& assembly() const { return assembly_; }
    [[nodiscard]] int equations() const { return layout_->equations(); }

    [[nodiscard]] Configuration rest() const;
    /// Move the prescribed components to this share of their values.
    void prescribe(double load_factor, Configuration& configuration) const;
    /// Add a step of the unknowns.
    void move(const Eigen::VectorXd& step, Configuration& configuration) const;
    /// The step of the unknowns from one configuration to another near it.
    [[nodiscard]] Eigen::VectorXd step_between(const Configuration& from, const Configuration& to) const;
    /// The rate at which such a step changes where the unknowns change at `rate` at its end.
    [[nodiscard]] Eigen::VectorXd rate_of_steps(const Eigen::VectorXd& step,
                                                const Eigen::VectorXd& rate) const;
    /// The largest rotation of a node in a step, rad.
    [[nodiscard]] double largest_rotation(const Eigen::VectorXd& step) const;
    /// Largest component of a step; displacements count in characteristic lengths.
    [[nodiscard]] double largest_component(const Eigen::VectorXd& step) const;

    /// For each equation 1 for a rotation and 1 / length^2 for a displacement: squares in one unit.
    [[nodiscard]] const Eigen::VectorXd& weights() const { return weights_; }

    /// Compute what the members below tell; the tangent and what depends on it only where it is asked for.
    void evaluate(const Configuration& configuration, double load_factor, Demand demand = Demand::Tangent);

    /// The solution at the configuration of the last evaluation, but for how it came about and whether it is
    /// stable.
    [[nodiscard]] Solution describe(const Configuration& configuration, double load_factor) const;

    /// Load less internal force, for each equation.
    [[nodiscard]] const Eigen::VectorXd& unbalanced() const { return unbalanced_; }
    /// Norm of the unbalanced forces over that of loads and reactions.
    [[nodiscard]] double relative_residual() const { return relative_residual_; }
    /// The rate of the unbalanced forces in the load factor while the unknowns rest.
    [[nodiscard]] const Eigen::VectorXd& load_rate() const { return load_rate_; }
    [[nodiscard]] double energy() const { return energy_; }
    [[nodiscard]] std::span<const double> tangent() const { return values_; }
    /// Whether moments make the tangent unsymmetric.
    [[nodiscard]] bool has_skew_part() const { return !skew_.empty(); }
    /// y = skew part of the tangent times x.
    [[nodiscard]] Eigen::VectorXd skew_product(const Eigen::VectorXd& x) const;
    /// True forces and moments of the supports.
    [[nodiscard]] NodeValues reactions() const;

  private:
    struct SkewBlock {
        std::array<int, 3> equation;
        Eigen::Matrix3d matrix;
    };
    [[nodiscard]] bool has_held_rotation(std::size_t node) const;
    [[nodiscard]] bool has_held_dof(int node, int dof) const;
    void map_spins(const Configuration& configuration);
    void add_elements(const Configuration& configuration, Demand demand);
    void evaluate_element(std::size_t index, const Configuration& configuration, Demand demand,
                          ElementResponse& response) const;
    void add_response(std::size_t index, const ElementResponse& response, Demand demand);
    void map_to_unknowns(std::span<const NodeIndex> nodes, Eigen::MatrixXd& tangent) const;
    void add_prescribed_rate(std::span<const NodeIndex> nodes, const Eigen::MatrixXd& tangent);
    void add_moment_terms(const Configuration& configuration, double load_factor);
    [[nodiscard]] Eigen::Matrix3d skew_of_moment(int node, double load_factor) const;
    void gather_unbalanced(double load_factor);

    const Assembly& assembly_;
    Constraints constraints_;
    double length_;
    double rounding_force_ = 0.0;
    Eigen::VectorXd weights_;
    std::unique_ptr<SystemLayout> layout_;
    std::vector<int> vector_nodes_;           ///< with held components of the rotation vector
    std::vector<int> vector_slot_;            ///< of each node in vector_nodes_, or -1
    std::vector<int> moment_nodes_;           ///< with applied moments and at least two free rotations
    std::vector<Eigen::Matrix3d> spin_maps_;  ///< of the vector nodes
    bool has_prescribed_ = false;
    int threads_;
    std::size_t batch_;  ///< elements that are evaluated before they are added
    std::vector<ElementResponse> responses_;

    NodeValues internal_;
    NodeValues forces_;  ///< loads less internal, true moments
    NodeValues prescribed_rate_;
    double energy_ = 0.0;
    double relative_residual_ = 0.0;
    std::vector<double> values_;
    std::vector<SkewBlock> skew_;
    Eigen::VectorXd unbalanced_;
    Eigen::VectorXd load_rate_;
};

}  // namespace fretwork::mechanics::detail
