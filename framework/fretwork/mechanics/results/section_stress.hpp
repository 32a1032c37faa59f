// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/frame/section.hpp>
#include <fretwork/mechanics/results/section_forces.hpp>

#include <Eigen/Core>

#include <vector>

namespace fretwork::mechanics {

/// The largest absolute stresses over a section, Pa. They may occur at different points.
struct SectionStress {
    double normal = 0.0;     ///< along the beam
    double shear = 0.0;      ///< in the plane of the section
    double von_mises = 0.0;  ///< sqrt(normal^2 + 3 shear^2), with both at one point
};

/// The points of a section at which stresses can be largest, and the stresses there for unit section forces.
///
/// Stresses are those of technical beam theory: bending is linear over the section; shear follows from
/// equilibrium with bending (Jourawski); torsion is free of warping stresses (Saint-Venant), a series for
/// rectangles [Timoshenko1951, 109], and linear across each plate of an I. Corners are sharp. Points lie 1/8
/// of half a side apart on rectangles, 1/32 of a turn on circles and tubes.
class SectionPoints {
  public:
    /// A section without a shape counts as the rectangle of its area and second moments.
    explicit SectionPoints(const Section& section);

    /// The largest stresses over the points. The cost is linear in the number of points, some 70.
    [[nodiscard]] SectionStress largest(const SectionForces& forces) const;

    /// The sum over the points of (von Mises stress / reference)^exponent.
    struct PowerSum {
        double value = 0.0;
        /// By N, V2, V3, T, M2, M3 (1/N and 1/(N m)).
        Eigen::Vector<double, 6> gradient = Eigen::Vector<double, 6>::Zero();
    };
    struct Power {
        double reference = 1.0;  ///< Pa, positive
        double exponent = 2.0;   ///< 2 or more, so that the sum is smooth where there is no stress
    };
    [[nodiscard]] PowerSum power_sum(const SectionForces& forces, const Power& power) const;

  private:
    struct Point {
        Eigen::RowVector3d normal;          ///< Pa, for N, M2 and M3 equal to 1
        Eigen::Matrix<double, 2, 3> shear;  ///< along axes 2 and 3, Pa, for V2, V3 and T equal to 1
    };
    class Builder;
    std::vector<Point> points_;
};

}  // namespace fretwork::mechanics
