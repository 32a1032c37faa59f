// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace fretwork::mechanics::elements {

/// The indices of a beam's deformations, which are zero in a rigid motion. t1 and t2 are the rotations of the
/// end sections relative to the chord, about the sections' own axis 2 (bending out of the plane of a flat
/// pattern) or axis 3 (bending in the plane):
inline constexpr int kElongation = 0;  ///< change of the chord's length, m
inline constexpr int kBow2 = 1;        ///< (t1 - t2) / 2 about axis 2: the arc of constant curvature
inline constexpr int kSway2 = 2;       ///< (t1 + t2) / 2 about axis 2: the S shape
inline constexpr int kBow3 = 3;        ///< (t1 - t2) / 2 about axis 3: the arc of constant curvature
inline constexpr int kSway3 = 4;       ///< (t1 + t2) / 2 about axis 3: the S shape
inline constexpr int kTwist = 5;       ///< rotation of end 2 relative to end 1 about the chord
inline constexpr int kBeamDeformations = 6;
using BeamVector = Eigen::Matrix<double, kBeamDeformations, 1>;
using BeamMatrix = Eigen::Matrix<double, kBeamDeformations, kBeamDeformations>;

/// The elastic energy of a beam as a function of its deformations d: the sum of stiffness * strain^2 / 2 over
/// six generalized strains. A strain is the deformation of the same name (axial: the elongation e), changed
/// by products of deformations:
///
///   axial  (e / L + ((bow2^2 + bow3^2) / 3 + q2 sway2^2 + q3 sway3^2) / 2) L    bending shortens the chord
///   bow2   (1 + twist^2 / 12 + g3^2 / 3) bow2 - g2 g3 bow3 / 3 + twist g3 / 2
///   bow3   (1 + twist^2 / 12 + g2^2 / 3) bow3 - g2 g3 bow2 / 3 - twist g2 / 2
///   sway2  + twist bow3 / 3                                          twist turns the plane of bending
///   sway3  - twist bow2 / 3
///   twist  / (1 + bow2^2 + bow3^2) + 2 (k3 bow2 sway3 - k2 bow3 sway2)    bending in two planes twists
///
/// with the shear ratios f2 = 12 E I2 / (G As3 L^2), f3 = 12 E I3 / (G As2 L^2), k = 1 / (1 + f), q = (1/5 -
/// f^2) k^2 and the shear angles g = f k sway. The products of two deformations follow from minimizing the
/// energy of the geometrically exact (Simo-Reissner) rod over all shapes between given ends. The products of
/// three deformations make the strains of a helix correct to fourth order. This matters because every piece
/// of a rod tends to a helix under refinement. They also make the strains correct for a rod with sections
/// inclined by a shear angle, which refinement does not reduce. The energy is a sum of squares and so never
/// negative. In a plane, the error falls with the fourth power of the length. In space, the error falls with
/// the fourth power if sections bend equally about both axes. Otherwise, and with shear, the error falls with
/// the second power.
class BeamEnergy {
  public:
    /// The stiffness of a beam's section. Stiffnesses are in N and N m^2, flexibilities in 1/N.
    struct Stiffness {
        double axial = 0.0;               ///< E A
        double torsion = 0.0;             ///< G J
        double bending2 = 0.0;            ///< E I2
        double bending3 = 0.0;            ///< E I3
        double shear_flexibility2 = 0.0;  ///< 1 / (G As2), shear along axis 2; zero: shear-rigid
        double shear_flexibility3 = 0.0;  ///< 1 / (G As3), shear along axis 3; zero: shear-rigid
    };
    BeamEnergy(const Stiffness& stiffness, double length);

    /// The energy and its derivatives at given deformations.
    struct State {
        double value = 0.0;
        BeamVector gradient;
        BeamMatrix strain_slopes;  ///< row i has the derivatives of strain i
        BeamVector stress;         ///< stiffness * strain
    };
    [[nodiscard]] State evaluate(const BeamVector& d) const;
    /// The second derivatives of the energy with respect to the deformations.
    /// @param stress  the stress that multiplies the strains' second derivatives: the stress of `state`, or a
    /// given stress
    [[nodiscard]] BeamMatrix hessian(const BeamVector& d, const State& state, const BeamVector& stress) const;
    /// The ratio of stress to strain for each strain. The Hessian at rest is the diagonal matrix of these
    /// ratios.
    [[nodiscard]] const BeamVector& stiffness() const { return stiffness_; }

  private:
    [[nodiscard]] BeamVector strains(const BeamVector& d) const;
    [[nodiscard]] BeamMatrix strain_slopes(const BeamVector& d) const;
    static void add_helix_terms(const BeamVector& d, const BeamVector& stress, BeamMatrix& h);
    void add_shear_terms(const BeamVector& d, const BeamVector& stress, BeamMatrix& h) const;

    BeamVector stiffness_;
    // Coefficients of the products in the strains.
    double bow_shortening_, sway2_shortening_, sway3_shortening_;
    double shear2_, shear3_;  ///< f k, the share of shear in the sway
    double twist2_, twist3_;
};

}  // namespace fretwork::mechanics::elements
