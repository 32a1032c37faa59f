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

/// The index of a node.
using NodeIndex = base::Index<struct NodeTag>;
/// The index of a beam.
using BeamIndex = base::Index<struct BeamTag>;

/// The six components of a node's displacement, in the order of every table and file.
// NOLINTBEGIN(readability-identifier-naming): as files and tables call them
enum class Dof {
    ux,  ///< displacement along x
    uy,  ///< displacement along y
    uz,  ///< displacement along z
    rx,  ///< x component of the rotation vector
    ry,  ///< y component of the rotation vector
    rz   ///< z component of the rotation vector
};
// NOLINTEND(readability-identifier-naming)
/// The number of components of a node's displacement.
inline constexpr int kDofsPerNode = 6;
/// The names of the components in files, in the order of Dof.
inline constexpr std::array<const char*, kDofsPerNode> kDofNames = {"ux", "uy", "uz", "rx", "ry", "rz"};
/// The name of a component.
constexpr const char* dof_name(Dof dof) {
    return kDofNames[static_cast<std::size_t>(dof)];
}

/// A set of components of a node's displacement.
struct DofSet {
    /// For each component, in the order of Dof, true if it is in the set.
    std::array<bool, kDofsPerNode> contains{};
    /// The set of all six components, for a clamp.
    static constexpr DofSet all() { return {{true, true, true, true, true, true}}; }
    /// The set of the three displacements, for a pin.
    static constexpr DofSet translations() { return {{true, true, true, false, false, false}}; }
    /// True if a component is in the set.
    constexpr bool& operator[](Dof dof) { return contains[static_cast<std::size_t>(dof)]; }
    /// True if a component is in the set.
    [[nodiscard]] constexpr bool operator[](Dof dof) const { return contains[static_cast<std::size_t>(dof)]; }
    /// Add the components of another set.
    constexpr DofSet& operator|=(const DofSet& other) {
        for (std::size_t d = 0; d < contains.size(); ++d) contains[d] = contains[d] || other.contains[d];
        return *this;
    }
    friend bool operator==(const DofSet&, const DofSet&) = default;
};

/// Values at nodes, one row for each node: the displacement ux uy uz in metres and the rotation vector rx ry
/// rz in radians; for loads and reactions, the force in newtons and the moment in newton metres.
using NodeValues = Eigen::Matrix<double, Eigen::Dynamic, kDofsPerNode, Eigen::RowMajor>;

/// A linear elastic, isotropic material.
struct Material {
    double young_modulus = 0.0;                   ///< Pa, > 0
    double poisson_ratio = 0.0;                   ///< Poisson's ratio, in (-1, 0.5]
    double density = 0.0;                         ///< kg/m^3, >= 0
    std::optional<double> given_shear_modulus{};  ///< shear modulus, Pa; none: E / (2 (1 + nu))
    /// The shear modulus G, Pa: the given value, or else E / (2 (1 + nu)).
    [[nodiscard]] double shear_modulus() const {
        return given_shear_modulus.value_or(young_modulus / (2.0 * (1.0 + poisson_ratio)));
    }
    friend bool operator==(const Material&, const Material&) = default;
};

/// A hinge at one end of a beam: the components that the end does not transmit to its node. They are in the
/// beam's local axes at rest, turned with the node.
struct Release {
    int end = 0;  ///< number of the end, 0 or 1
    DofSet free;  ///< components in which the end may move
    friend bool operator==(const Release&, const Release&) = default;
};

/// The largest number of elements of one beam. For a cantilever with this number of elements, the relative
/// error of the tip's deflection is at most 1e-5 (2.4e-7 under a force at the tip, 2e-6 under its own
/// weight). With more elements, rounding dominates, because an element's stiffness grows with the cube of the
/// number: ten thousand elements lose a third of the deflection.
inline constexpr int kMostDivisions = 1000;

/// A straight beam between two nodes.
struct Beam {
    std::array<NodeIndex, 2> nodes;  ///< the ends of the beam
    Section section;                 ///< uniform along the beam
    Material material;               ///< uniform along the beam
    /// A vector that, less its part along the beam, is the direction of local axis 3 at rest; none: global z,
    /// or global y for a beam along z.
    std::optional<Eigen::Vector3d> normal{};
    int divisions = 1;                ///< number of elements
    std::vector<Release> releases{};  ///< hinges at the ends
};

/// The fixed components of a node. A fixed rotation component means that this component of the node's total
/// rotation vector stays zero.
struct Support {
    NodeIndex node;  ///< the node
    DofSet fixed;    ///< components that stay zero
};

/// A component of a node's displacement that has a given value. It counts as held, and needs no Support.
struct PrescribedDisplacement {
    NodeIndex node;      ///< the node
    Dof dof;             ///< the component
    double value = 0.0;  ///< value, m for a displacement, rad for a component of the rotation vector
};

/// A force and a moment of fixed direction in space. Several loads on one node add up.
struct NodalLoad {
    NodeIndex node;                                    ///< the node
    Eigen::Vector3d force = Eigen::Vector3d::Zero();   ///< N
    Eigen::Vector3d moment = Eigen::Vector3d::Zero();  ///< N m
};

/// A structure of beams.
struct Frame {
    base::IndexVector<NodeIndex, Eigen::Vector3d> nodes;  ///< rest positions, metres
    base::IndexVector<BeamIndex, Beam> beams;             ///< the beams
    std::vector<Support> supports;                        ///< components that stay zero
    std::vector<PrescribedDisplacement> prescribed;       ///< components with given values
    std::vector<NodalLoad> loads;                         ///< forces and moments on nodes
    Eigen::Vector3d gravity = Eigen::Vector3d::Zero();    ///< m/s^2
};

/// A frame from a file in which nodes have labels.
struct LabelledFrame {
    Frame frame;                               ///< the frame itself
    base::IndexVector<NodeIndex, int> labels;  ///< label of each node of the frame, in the order of the file
    std::string source{};                      ///< name of the file, for messages
};

/// Check that a frame is valid: it has a beam; indices are in range, and numbers within base::Limits; beams
/// are longer than zero, and no normal runs along its beam; each node has a beam, or all its components are
/// held; each connected part is held against every rigid motion, hinges ignored; no component is prescribed
/// twice; and each beam has a density if gravity acts. Throws InputError or GeometryError that names the
/// place ("/beams/3").
void validate(const Frame& frame);

}  // namespace fretwork::mechanics
