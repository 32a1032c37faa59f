// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/element.hpp>
#include <fretwork/mechanics/elements/beam_energy.hpp>

namespace fretwork::mechanics::elements {

/// The motions on which deformations depend, as indices of a MotionVector: the chord's vector, and the spins
/// of the two ends.
inline constexpr int kChord = 0;
inline constexpr int kSpin1 = 3;
inline constexpr int kSpin2 = 6;
inline constexpr int kMotions = 9;
using MotionVector = Eigen::Matrix<double, kMotions, 1>;
using MotionMatrix = Eigen::Matrix<double, kMotions, kMotions>;
using DeformationSlopes = Eigen::Matrix<double, kBeamDeformations, kMotions>;

/// The function F(c) = a / sin a, with c = cos a, and its derivatives. A direction at the angle a from an
/// axis has a part of length sin a across the axis; F times this part has the length of the rotation vector
/// from the axis to the direction. F' and F'' follow from the differential equation (1 - c^2) F' = c F - 1.
struct AngleRatio {
    double value;
    double slope;
    double curvature;
};

/// The direction of the chord in the axes of an end section.
struct EndView {
    double c, p2, p3;  ///< components of the chord's direction along the section's axes
    AngleRatio ratio;
    [[nodiscard]] double bend2() const { return ratio.value * p3; }
    [[nodiscard]] double bend3() const { return -ratio.value * p2; }
};

/// The deformations of a beam for given states of its ends, and their derivatives with respect to the motions
/// (MotionVector).
class BeamDeformation {
  public:
    /// @param axes    the beam's local axes at rest, as columns
    /// @param length  length at rest, m
    BeamDeformation(const Eigen::Matrix3d& axes, double length, std::span<const NodeState> ends);

    [[nodiscard]] BeamVector values() const;
    [[nodiscard]] DeformationSlopes slopes() const;
    /// The sum over all deformations of stress times second derivative.
    [[nodiscard]] MotionMatrix curvature(const BeamVector& stress) const;

  private:
    struct BowShare {
        int spin;    ///< kSpin1 or kSpin2
        double bow;  ///< coefficient of this end's rotation in the bow
    };
    struct EndStress {
        int spin;
        double bend2, bend3;
    };
    [[nodiscard]] Eigen::Matrix3d chord_projection() const;
    void add_end_slopes(const EndView& end, const Eigen::Matrix3d& axes, BowShare share,
                        DeformationSlopes& s) const;
    void add_end_curvature(const EndView& end, const Eigen::Matrix3d& axes, EndStress stress,
                           MotionMatrix& m) const;
    [[nodiscard]] Eigen::Matrix<double, 6, 1> dot_slope(const Eigen::Vector3d& b) const;
    void add_dot_curvature(const Eigen::Vector3d& b, int spin, MotionMatrix& m) const;
    [[nodiscard]] Eigen::Vector3d sine_slope() const;
    [[nodiscard]] Eigen::Vector3d cosine_slope() const;
    [[nodiscard]] Eigen::Vector3d twist_slope() const;
    void add_twist_curvature(double stress, MotionMatrix& m) const;

    Eigen::Matrix3d axes1_, axes2_;  ///< the axes of the end sections
    Eigen::Vector3d direction_;      ///< unit vector along the chord
    double length_ = 0.0;            ///< length of the chord, m
    double elongation_ = 0.0;
    EndView end1_{}, end2_{};
    /// Sine and cosine of the twist, both multiplied by the same factor of at most one.
    double sine_ = 0.0, cosine_ = 1.0;
};

}  // namespace fretwork::mechanics::elements
