// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

namespace fretwork::mechanics {

/// The cross-section of a beam. Local axis 1 runs along the beam, axis 3 is the beam's normal, axis 2 = axis
/// 3 x axis 1.
struct Section {
    double area = 0.0;  ///< m^2
    double I2 = 0.0;    ///< m^4; bends about axis 2: out of plane, for a beam in a flat pattern
    double I3 = 0.0;    ///< m^4; bends about axis 3: in the plane
    double J = 0.0;     ///< m^4; torsion constant
    std::optional<double>
        shear_area2{};  ///< m^2, for shear along axis 2; none: shear-rigid (Euler-Bernoulli)
    std::optional<double> shear_area3{};  ///< m^2, for shear along axis 3; none: shear-rigid
    friend bool operator==(const Section&, const Section&) = default;
};

/// The sides of the rectangle that has a section's area and second moments, metres.
double rectangle_width(const Section& section);   ///< along local axis 2
double rectangle_height(const Section& section);  ///< along local axis 3

/// `width` lies along local axis 2, `height` along local axis 3 (metres); J is Saint-Venant's series.
Section rectangle_section(double width, double height);
Section circle_section(double diameter);
Section tube_section(double outer_diameter, double inner_diameter);

}  // namespace fretwork::mechanics
