// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/frame/section.hpp>
#include <fretwork/mechanics/results/section_forces.hpp>

#include <Eigen/Core>

#include <vector>

namespace fretwork::mechanics {

/// The largest absolute stresses over a section, Pa. The three stresses may occur at different points.
struct SectionStress {
    double normal = 0.0;     ///< normal stress along the beam
    double shear = 0.0;      ///< shear stress in the plane of the section
    double von_mises = 0.0;  ///< largest sqrt(normal^2 + 3 shear^2) of the stresses at one point
};

/// The points of a section at which stresses can be largest, with their stresses for unit section forces.
///
/// Stresses follow technical beam theory. Bending stresses are linear over the section. Stresses of a shear
/// force follow from equilibrium with bending (Jourawski). Torsion has no warping stresses (Saint-Venant):
/// its stresses are a series for rectangles [Timoshenko1951, 109], and linear across each plate of an I.
/// Corners are sharp. Points lie 1/8 of half a side apart on rectangles, 1/32 of a turn on circles and tubes.
class SectionPoints {
  public:
    /// Find the points of a section. A section without a shape counts as the rectangle with its radii of
    /// gyration.
    explicit SectionPoints(const Section& section);

    /// The largest stresses over the points. The cost is linear in the number of points, at most 65.
    [[nodiscard]] SectionStress largest(const SectionForces& forces) const;

    /// The sum over the points of (von Mises stress / reference)^exponent.
    struct PowerSum {
        double value = 0.0;  ///< the sum
        /// The derivatives of the sum with respect to N, V2, V3, T, M2, M3 (1/N and 1/(N m)).
        Eigen::Vector<double, 6> gradient = Eigen::Vector<double, 6>::Zero();
    };
    /// The exponent and the reference stress of the sum.
    struct Power {
        double reference = 1.0;  ///< reference stress, Pa, positive
        double exponent = 2.0;   ///< exponent, at least 2, so that the sum is smooth where the stress is zero
    };
    /// The sum and its derivatives. The cost is linear in the number of points.
    [[nodiscard]] PowerSum power_sum(const SectionForces& forces, const Power& power) const;

  private:
    struct Point {
        Eigen::RowVector3d normal;  ///< normal stress for N, M2 and M3 equal to 1, Pa
        /// Shear stresses along axes 2 and 3 for V2, V3 and T equal to 1, Pa.
        Eigen::Matrix<double, 2, 3> shear;
    };
    class Builder;
    std::vector<Point> points_;
};

}  // namespace fretwork::mechanics
