// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/element.hpp>
#include <fretwork/mechanics/frame/frame.hpp>
#include <fretwork/mechanics/results/solution.hpp>

#include <Eigen/Core>

#include <array>

namespace fretwork::mechanics {

/// The section forces at a cut: the forces and moments that the material beyond the cut exerts, along the
/// beam's local axes, which turn with the beam. Positive N is tension; M2 and M3 act about axes 2 and 3 (V3 =
/// dM2/ds, V2 = -dM3/ds).
struct SectionForces {
    double N = 0.0;   ///< axial force, N
    double V2 = 0.0;  ///< shear force along axis 2, N
    double V3 = 0.0;  ///< shear force along axis 3, N
    double T = 0.0;   ///< torsional moment, N m
    double M2 = 0.0;  ///< bending moment about axis 2, N m
    double M3 = 0.0;  ///< bending moment about axis 3, N m
};

/// A straight beam that computes the section forces at both ends from the motions of the ends. Loads between
/// the ends, such as the beam's weight, are left out. One BeamSection serves many states of the beam.
class BeamSection {
  public:
    /// The section forces at both ends.
    using Ends = std::array<SectionForces, 2>;

    /// Prepare a beam. The beam's nodes, divisions and hinges are ignored. Throws GeometryError if the beam's
    /// length is zero, or if its normal runs along it.
    /// @param ends  rest positions of the ends, m
    BeamSection(const Beam& beam, const std::array<Eigen::Vector3d, 2>& ends);

    /// The section forces for small displacements ux uy uz rx ry rz of each end.
    [[nodiscard]] Ends linear(const Eigen::Vector<double, 6>& start,
                              const Eigen::Vector<double, 6>& end) const;
    /// The section forces for displacements and rotations of any size, as in the beam element for large
    /// displacements.
    [[nodiscard]] Ends large(const NodeState& start, const NodeState& end) const;

  private:
    using Deformations = Eigen::Vector<double, 6>;
    [[nodiscard]] Ends from_gradient(const Deformations& gradient) const;

    double length_;
    Eigen::Matrix3d axes_;  ///< local axes at rest, as columns
    Section section_;
    Material material_;
    Deformations stiffness_;  ///< stiffness of BeamEnergy, at rest
};

}  // namespace fretwork::mechanics
