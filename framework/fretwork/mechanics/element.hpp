// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/frame/frame.hpp>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <span>

namespace fretwork::mechanics {

/// The position and orientation of a node. The rotation is a quaternion, so rotations of any size have no
/// singular point.
struct NodeState {
    Eigen::Vector3d displacement = Eigen::Vector3d::Zero();        ///< displacement, m
    Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();  ///< rotation from rest, of unit norm
};

/// An element's response to the states of its nodes.
///
/// The response has six components for each node: three of its displacement and three of its spin. A spin is
/// an infinitesimal rotation w in space, R <- exp(w) R. To second order in w, the energy is E + force . w + w
/// . tangent . w / 2. So the force is the gradient of the energy, and the tangent is symmetric. The plain
/// derivative of the force along a spin differs from the tangent by - [m]/2 on the rotational diagonal block
/// of each node, where m is the node's moment and [m] w = m x w. In equilibrium, the moments m of all
/// elements sum to the applied moments and reactions.
struct ElementResponse {
    double energy = 0.0;      ///< energy, J
    Eigen::VectorXd force;    ///< forces and moments on the nodes, 6n, N and N m
    Eigen::MatrixXd tangent;  ///< tangent, 6n x 6n, symmetric; computed only with Demand::Tangent
};

/// The requested quantities of an element.
enum class Demand {
    Force,   ///< energy and forces
    Tangent  ///< energy, forces and tangent
};

/// The stresses of one element in a mixed iteration. The caller owns the memory of the spans.
struct ElementStresses {
    /// Stresses that replace the element's own stresses in the geometric terms.
    std::span<const double> given;
    std::span<double> own;     ///< out: the element's own stresses, s = K e(x)
    std::span<double> slopes;  ///< out, only with Demand::Tangent: B = de/dx along small motions of the
                               ///< nodes, stress_count() x 6n, column by column
};

/// An element's response with given stresses: the true energy, the true force B^T s from the own stresses s,
/// and the tangent B^T K B + sum of given_i d2e_i/dx2.
struct MixedResponse : ElementResponse {
    Eigen::VectorXd given_force;  ///< force of the given stresses, 6n: B^T given
};

/// A component of a structure with any number of nodes, such as a beam or a condensed tile. Elements are
/// immutable, so threads may share them. No function has a default, because a default could be wrong without
/// notice.
class Element {
  public:
    Element() = default;
    Element(const Element&) = delete;
    Element& operator=(const Element&) = delete;
    virtual ~Element() = default;

    /// The nodes of the assembly that this element connects.
    [[nodiscard]] virtual std::span<const NodeIndex> nodes() const = 0;

    /// Write the linear stiffness at rest, 6n x 6n: the tangent at zero displacement. The caller owns the
    /// matrix and reuses it for the next element, which saves allocations.
    virtual void rest_stiffness(Eigen::MatrixXd& stiffness) const = 0;

    /// Write the response to the states of the nodes (in the order of nodes()). As in rest_stiffness, the
    /// caller owns the buffers. An element without a response in these states writes NaN.
    virtual void evaluate(std::span<const NodeState> states, Demand demand,
                          ElementResponse& response) const = 0;

    /// The number of stresses s = K e of an element with the energy e . K e / 2, where the strains e(x)
    /// depend on the states of the nodes and the stiffness K is constant. Zero for an element with another
    /// form of energy, or with linear strains.
    [[nodiscard]] virtual Eigen::Index stress_count() const = 0;

    /// Write the response with given stresses, and the element's own stresses. As in evaluate(), the caller
    /// owns the buffers. If the given stresses are the element's own stresses, or if stress_count() is zero,
    /// the response equals that of evaluate(), and given_force is the force.
    ///
    /// With stresses s + K B dx, which are extrapolated from the last iteration, Newton's method can take far
    /// longer steps [Magisano2017]. The stresses at the current displacements can be huge, because the
    /// membrane stiffness is high.
    virtual void evaluate_mixed(std::span<const NodeState> states, Demand demand,
                                const ElementStresses& stresses, MixedResponse& response) const = 0;

    /// Write the stresses K e of given strains. Both spans have stress_count() entries.
    virtual void stresses_of(std::span<const double> strains, std::span<double> stresses) const = 0;

    /// The rotation that the element knows only up to whole turns, rad: a beam's twist, or the largest
    /// rotation of a node relative to corotating axes (infinite without such axes). On a path, its size must
    /// stay below pi. Zero for an element that is valid at any relative rotation, or for small rotations
    /// only.
    [[nodiscard]] virtual double relative_turn(std::span<const NodeState> states) const = 0;

    /// Write the geometric stiffness, 6n x 6n: the change of the stiffness at rest by the internal forces
    /// that small displacements (6n) cause. The stiffness is linear in the displacements. The change of the
    /// geometry itself is left out, as in linearized buckling.
    virtual void geometric_stiffness(const Eigen::VectorXd& displacements,
                                     Eigen::MatrixXd& stiffness) const = 0;

    /// Write the consistent mass at rest, 6n x 6n (kg, kg m, kg m^2). Throws InputError if the mass is not
    /// known.
    virtual void mass(Eigen::MatrixXd& mass) const = 0;
};

}  // namespace fretwork::mechanics
