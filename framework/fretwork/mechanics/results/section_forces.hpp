// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/element.hpp>
#include <fretwork/mechanics/frame/frame.hpp>
#include <fretwork/mechanics/results/solution.hpp>

#include <Eigen/Core>

#include <array>

namespace fretwork::mechanics {

/// The forces and moments of the material on the far side of a cut, along the beam's local axes as they turn
/// with it: N pulls, M2 and M3 turn about axes 2 and 3 (V3 = dM2/ds, V2 = -dM3/ds).
struct SectionForces {
    double N = 0.0;   ///< N, axial
    double V2 = 0.0;  ///< N, shear along axis 2
    double V3 = 0.0;  ///< N, shear along axis 3
    double T = 0.0;   ///< N m, torsion
    double M2 = 0.0;  ///< N m, bending about axis 2
    double M3 = 0.0;  ///< N m, bending about axis 3
};

/// The section forces at both ends of a straight beam, from how its ends move. Made once for a beam, and
/// asked for many states.
class BeamSection {
  public:
    using Ends = std::array<SectionForces, 2>;

    /// The beam without its divisions and hinges. Throws GeometryError if it has no length.
    BeamSection(const Beam& beam, const std::array<Eigen::Vector3d, 2>& ends);

    /// For small displacements: ux uy uz rx ry rz of each end.
    [[nodiscard]] Ends linear(const Eigen::Vector<double, 6>& start,
                              const Eigen::Vector<double, 6>& end) const;
    /// For displacements and rotations of any size, as the corotational beam element has them.
    [[nodiscard]] Ends large(const NodeState& start, const NodeState& end) const;

  private:
    using Deformations = Eigen::Vector<double, 6>;
    [[nodiscard]] Ends from_gradient(const Deformations& gradient) const;

    double length_;
    Eigen::Matrix3d axes_;  ///< at rest, as columns
    Section section_;
    Material material_;
    Deformations stiffness_;  ///< at rest
};

}  // namespace fretwork::mechanics
