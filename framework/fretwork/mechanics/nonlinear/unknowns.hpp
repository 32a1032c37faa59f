// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/assembly.hpp>
#include <fretwork/mechanics/sparse/system_layout.hpp>
#include <fretwork/mechanics/structure/constraints.hpp>

#include <cmath>
#include <memory>
#include <vector>

namespace fretwork::mechanics::nonlinear {

/// The states of all nodes, and their rotation vectors, which are continuous along the path.
struct Configuration {
    std::vector<NodeState> states;
    std::vector<Eigen::Vector3d> rotation_vectors;
};

/// The equilibrium at the beginning of a path that does not begin at rest. Along the path, loads and held
/// components change linearly from their values at this equilibrium to those of the assembly.
struct PathStart {
    Configuration configuration;
    NodeValues loads;     ///< loads at the equilibrium, one row for each node
    NodeValues released;  ///< forces of removed supports, which act at the equilibrium besides the loads
};

/// The unknown components of a structure's nodes, and functions that move a configuration by steps of them.
///
/// The rotational unknowns of a node that turns freely are spins. If supports hold some components of a
/// node's total rotation vector, the rotational unknowns are the other components of this vector.
class Unknowns {
  public:
    /// Find the unknowns of an assembly, which must outlive this object. Throws Stopped.
    explicit Unknowns(const Assembly& assembly, const base::Control& control = {});

    [[nodiscard]] const sparse::SystemLayout& layout() const { return *layout_; }
    [[nodiscard]] const Assembly& assembly() const { return assembly_; }
    [[nodiscard]] int equations() const { return layout_->equations(); }

    /// Begin the path at a configuration instead of at rest.
    void begin_at(const Configuration& start);
    /// Take over changed prescribed values of the assembly. The set of held components must be unchanged.
    void refresh();

    [[nodiscard]] Configuration rest() const;
    /// Move the prescribed components to their values at a load factor.
    void prescribe(double load_factor, Configuration& configuration) const;
    /// Move all held components to their values at the full load. Returns the motions of the nodes.
    NodeValues hold(Configuration& configuration) const;
    /// Add a step of the unknowns to a configuration.
    void move(const Eigen::VectorXd& step, Configuration& configuration) const;
    /// Add whole turns to the rotation vectors, so that each is nearest to its value at the last equilibrium.
    /// Rotation vectors are then continuous along a path, whatever happens during the iterations.
    void unwind(const Configuration& last, Configuration& configuration) const;
    /// The step of the unknowns from one configuration to another near it.
    [[nodiscard]] Eigen::VectorXd step_between(const Configuration& from, const Configuration& to) const;
    /// The rate of change of a step from step_between() if the unknowns at its end change at `rate`.
    [[nodiscard]] Eigen::VectorXd rate_of_steps(const Eigen::VectorXd& step,
                                                const Eigen::VectorXd& rate) const;
    /// The largest rotation of a node in a step, rad.
    [[nodiscard]] double largest_rotation(const Eigen::VectorXd& step) const;
    /// The largest component of a step; displacements count in characteristic lengths.
    [[nodiscard]] double largest_component(const Eigen::VectorXd& step) const;

    /// The weight of each equation in sums of squares: 1 for a rotation, 1 / length^2 for a displacement.
    [[nodiscard]] const Eigen::VectorXd& weights() const { return weights_; }
    /// The product of two steps in these weights.
    [[nodiscard]] double product(const Eigen::VectorXd& a, const Eigen::VectorXd& b) const {
        return a.dot(weights_.cwiseProduct(b));
    }
    /// The length of a step in these weights.
    [[nodiscard]] double size_of(const Eigen::VectorXd& step) const { return std::sqrt(product(step, step)); }

    [[nodiscard]] const structure::Constraints& constraints() const { return constraints_; }
    /// The derivative of the held components with respect to the load factor; zero for other components.
    [[nodiscard]] const NodeValues& prescribed_change() const { return prescribed_change_; }
    [[nodiscard]] bool is_held(int node, int dof) const;
    [[nodiscard]] bool has_held_rotation(int node) const;
    [[nodiscard]] bool has_prescribed() const { return has_prescribed_; }
    /// True if all held components are zero at a load factor.
    [[nodiscard]] bool holds_at_rest(double load_factor) const {
        return (load_factor * constraints_.values + (1.0 - load_factor) * start_).isZero(0.0);
    }
    /// The largest rotation that is prescribed at a node from the beginning of the path to the full load,
    /// rad.
    [[nodiscard]] double largest_prescribed_rotation() const {
        return prescribed_change_.rightCols<3>().rowwise().norm().maxCoeff();
    }
    /// The characteristic length of the elements, m.
    [[nodiscard]] double length() const { return length_; }
    /// The vector nodes: nodes whose rotation vector is partly held, or held at other values than zero.
    /// vector_slot() gives the index of a node among them, or -1.
    [[nodiscard]] const std::vector<int>& vector_nodes() const { return vector_nodes_; }
    [[nodiscard]] int vector_slot(int node) const { return vector_slot_[node]; }

  private:
    void take_up_prescribed();
    void find_vector_nodes();

    const Assembly& assembly_;
    structure::Constraints constraints_;
    double length_;
    NodeValues start_;              ///< held components at the beginning of the path
    NodeValues prescribed_change_;  ///< change of the held components from there to the full load
    std::unique_ptr<sparse::SystemLayout> layout_;
    std::vector<int> vector_nodes_;
    std::vector<int> vector_slot_;
    bool has_prescribed_ = false;
    Eigen::VectorXd weights_;
};

/// Choose the rotation vectors of an equilibrium whose way from rest is not known. The vectors of a rotation
/// differ by whole turns. Each node gets the vector that continues along the elements, with less than half a
/// turn in each element, from the nearest node whose rotation is held. Nodes with a prescribed component of
/// rotation keep their vector. In a part of the structure without such nodes, the vector of one node, which
/// is supported if any node is, has a length of at most pi. The rotations themselves are unchanged.
void continue_along_elements(const Unknowns& unknowns, Configuration& configuration);

}  // namespace fretwork::mechanics::nonlinear
