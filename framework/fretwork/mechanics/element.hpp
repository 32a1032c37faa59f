// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/frame/frame.hpp>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <span>

namespace fretwork::mechanics {

/// Where a node is and how it is turned. The rotation is kept as a rotation, so that turns of any size, and
/// any number of them, have no singular point.
struct NodeState {
    Eigen::Vector3d displacement = Eigen::Vector3d::Zero();        ///< metres
    Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();  ///< from rest, unit
};

/// An element's answer to the states of its nodes.
///
/// For each node in turn, three components belong to its displacement and three to its spin: an infinitesimal
/// rotation w in space, R <- exp(w) R. Along spins w_i the energy is, to second order,
/// E + force . w + w . tangent . w / 2: the force is the gradient and the tangent is symmetric. The plain
/// derivative of the force along a spin is the tangent - [m]/2 on the rotational diagonal block of each
/// node, where m is the node's moment and [m] w = m x w; these skew parts add up to the applied moments.
struct ElementResponse {
    double energy = 0.0;      ///< J
    Eigen::VectorXd force;    ///< 6n: N and N m
    Eigen::MatrixXd tangent;  ///< 6n x 6n, symmetric; only where it was asked for
};

/// The requested quantities of an element.
enum class Demand { Force, Tangent };

/// The stresses of one element in a mixed iteration, in memory of the caller.
struct ElementStresses {
    std::span<const double> given;  ///< stand in the geometric terms, in place of the element's own
    std::span<double> own;          ///< out: s = K e(x)
    std::span<double> slopes;  ///< out, only where the tangent is asked for: B = de/dx along small motions
                               ///< of the nodes, stress_count() x 6n, column by column
};

/// An element's answer to given stresses: the true energy and force B^T s, and a tangent B^T K B + sum of
/// given_i d2e_i/dx2.
struct MixedResponse : ElementResponse {
    Eigen::VectorXd given_force;  ///< 6n: B^T given
};

/// A part of a structure with any number of nodes: a beam, a condensed tile. Immutable, so that threads may
/// share it. Every kind answers all of these questions: none has a default that could be wrong in silence.
class Element {
  public:
    Element() = default;
    Element(const Element&) = delete;
    Element& operator=(const Element&) = delete;
    virtual ~Element() = default;

    /// The nodes of the assembly that this element connects.
    [[nodiscard]] virtual std::span<const NodeIndex> nodes() const = 0;

    /// Write the linear stiffness at rest, 6n x 6n: the tangent at zero displacement. The caller owns the
    /// matrix and passes it again for the next element, so that the loop over elements allocates nothing.
    virtual void rest_stiffness(Eigen::MatrixXd& stiffness) const = 0;

    /// Write the response to the states of the nodes (in the order of nodes()). As in rest_stiffness, the
    /// caller owns the buffers.
    virtual void evaluate(std::span<const NodeState> states, Demand demand,
                          ElementResponse& response) const = 0;

    /// The number of stresses of an element whose energy is e . K e / 2, with strains e(x) of its nodes'
    /// states and a constant stiffness K: s = K e. Zero for an element that is not, or whose strains are
    /// linear.
    [[nodiscard]] virtual Eigen::Index stress_count() const = 0;

    /// Write the response with given stresses, and the element's own: as in evaluate(), the caller owns the
    /// buffers. With its own stresses given this is evaluate(); so it is always where stress_count() is zero,
    /// and then given_force is the force.
    ///
    /// Newton's method with stresses that are extrapolated from the last iteration, s + K B dx, takes far
    /// longer steps than with those of the current displacements, in which membrane stiffness shows as huge
    /// stresses. [Magisano2017]
    virtual void evaluate_mixed(std::span<const NodeState> states, Demand demand,
                                const ElementStresses& stresses, MixedResponse& response) const = 0;

    /// Write the stresses K e of these strains, stress_count() of each.
    virtual void stresses_of(std::span<const double> strains, std::span<double> stresses) const = 0;

    /// How far the element's ends are turned against each other, rad, where this is known only up to whole
    /// turns: a path must not let it come to pi. Zero for an element that is right at any such turn, or meant
    /// for none.
    [[nodiscard]] virtual double relative_turn(std::span<const NodeState> states) const = 0;

    /// Write the geometric stiffness, 6n x 6n: how the internal forces of small displacements (6n, linear)
    /// change the stiffness at rest. The change of the geometry itself is left out, as in linearized
    /// buckling.
    virtual void geometric_stiffness(const Eigen::VectorXd& displacements,
                                     Eigen::MatrixXd& stiffness) const = 0;

    /// Write the consistent mass at rest, 6n x 6n (kg, kg m, kg m^2). Throws InputError if it is not known.
    virtual void mass(Eigen::MatrixXd& mass) const = 0;
};

}  // namespace fretwork::mechanics
