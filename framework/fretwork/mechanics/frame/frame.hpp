// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/index_vector.hpp>
#include <fretwork/mechanics/frame/section.hpp>

#include <Eigen/Core>

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace fretwork::mechanics {

/// Counts nodes.
using NodeIndex = base::Index<struct NodeTag>;
/// Counts beams.
using BeamIndex = base::Index<struct BeamTag>;

/// The six components of a node's displacement, in the order of every table and file.
// NOLINTNEXTLINE(readability-identifier-naming): as files and tables call them
enum class Dof {
    ux,  ///< displacement along x
    uy,  ///< displacement along y
    uz,  ///< displacement along z
    rx,  ///< rotation vector's x
    ry,  ///< rotation vector's y
    rz   ///< rotation vector's z
};
/// Displacements and rotations of a node.
inline constexpr int kDofsPerNode = 6;
/// Their names in files, in the order of Dof.
inline constexpr std::array<const char*, kDofsPerNode> kDofNames = {"ux", "uy", "uz", "rx", "ry", "rz"};
/// The name of a component.
constexpr const char* dof_name(Dof dof) {
    return kDofNames[static_cast<std::size_t>(dof)];
}

/// A set of dofs: entry d says whether dof d is in it.
struct DofSet {
    std::array<bool, kDofsPerNode> contains{};  ///< in the order of Dof
    /// All six: a clamp.
    static constexpr DofSet all() { return {{true, true, true, true, true, true}}; }
    /// The three displacements: a pin.
    static constexpr DofSet translations() { return {{true, true, true, false, false, false}}; }
    /// Whether a component is in it.
    constexpr bool& operator[](Dof dof) { return contains[static_cast<std::size_t>(dof)]; }
    /// Whether a component is in it.
    [[nodiscard]] constexpr bool operator[](Dof dof) const { return contains[static_cast<std::size_t>(dof)]; }
    friend bool operator==(const DofSet&, const DofSet&) = default;
};

/// One row for each node: ux uy uz in metres, then the rotation vector rx ry rz in radians (or, for loads and
/// reactions, force in newtons and moment in newton metres).
using NodeValues = Eigen::Matrix<double, Eigen::Dynamic, kDofsPerNode, Eigen::RowMajor>;

/// A linear elastic, isotropic material.
struct Material {
    double young_modulus = 0.0;                   ///< Pa, > 0
    double poisson_ratio = 0.0;                   ///< in (-1, 0.5]
    double density = 0.0;                         ///< kg/m^3, >= 0
    std::optional<double> given_shear_modulus{};  ///< Pa; without it, E / (2 (1 + nu))
    /// G, Pa: as given, or from Young's modulus and Poisson's ratio.
    [[nodiscard]] double shear_modulus() const {
        return given_shear_modulus.value_or(young_modulus / (2.0 * (1.0 + poisson_ratio)));
    }
    friend bool operator==(const Material&, const Material&) = default;
};

/// A hinge at one end of a beam: the components, in the beam's local axes at rest, that the end does not
/// transmit to its node.
struct Release {
    int end = 0;  ///< 0 or 1
    DofSet free;  ///< components that the end may move in
    friend bool operator==(const Release&, const Release&) = default;
};

/// The most elements of one beam. A cantilever of this number of elements has a relative error of the tip's
/// deflection of at most 1e-5 (2.4e-7 under a force at its tip, 2e-6 under its own weight). With more
/// elements rounding dominates, because the stiffness grows with the cube of their number: with ten thousand,
/// a third of the deflection is lost.
inline constexpr int kMostDivisions = 1000;

/// A straight beam between two nodes.
struct Beam {
    std::array<NodeIndex, 2> nodes;  ///< its ends
    Section section;                 ///< the same all along
    Material material;               ///< the same all along
    std::optional<Eigen::Vector3d>
        normal{};       ///< local axis 3 at rest; if empty, global z, or global y for a beam along z
    int divisions = 1;  ///< number of elements
    std::vector<Release> releases{};  ///< hinges at its ends
};

/// The fixed components of a node. A fixed rotation component means that this component of the node's total
/// rotation vector stays zero.
struct Support {
    NodeIndex node;  ///< which node
    DofSet fixed;    ///< components that stay zero
};

/// A component of a node's displacement with a given value. It acts as a support, too.
struct PrescribedDisplacement {
    NodeIndex node;      ///< which node
    Dof dof;             ///< which component
    double value = 0.0;  ///< metres or radians (component of the rotation vector)
};

/// A force and a moment of fixed direction in space. Several loads on one node add up.
struct NodalLoad {
    NodeIndex node;                                    ///< which node
    Eigen::Vector3d force = Eigen::Vector3d::Zero();   ///< N
    Eigen::Vector3d moment = Eigen::Vector3d::Zero();  ///< N m
};

/// A structure of beams.
struct Frame {
    base::IndexVector<NodeIndex, Eigen::Vector3d> nodes;  ///< rest positions, metres
    base::IndexVector<BeamIndex, Beam> beams;             ///< what bears
    std::vector<Support> supports;                        ///< components that stay zero
    std::vector<PrescribedDisplacement> prescribed;       ///< components that are given
    std::vector<NodalLoad> loads;                         ///< forces and moments on nodes
    Eigen::Vector3d gravity = Eigen::Vector3d::Zero();    ///< m/s^2
};

/// A frame from a file whose nodes have labels.
struct LabelledFrame {
    Frame frame;                               ///< the frame itself
    base::IndexVector<NodeIndex, int> labels;  ///< one for each node of the frame, in the file's order
    std::string source{};                      ///< the file, for messages
};

/// Check that a frame is valid: indices are in range, numbers finite, sections positive, and beams longer
/// than zero; each node has a beam or is surely held; each connected part of the structure has a support; and
/// each beam has a density if gravity acts. Throws InputError or GeometryError that names the node or beam
/// ("/beams/3").
void validate(const Frame& frame);

}  // namespace fretwork::mechanics
