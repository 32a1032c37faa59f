// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <variant>

namespace fretwork::mechanics {

/// Shapes of cross-sections; lengths in metres. Widths lie along local axis 2, heights along axis 3.
struct RectangleShape {
    double width = 0.0;   ///< m, in the pattern's plane
    double height = 0.0;  ///< m, across it
    friend bool operator==(const RectangleShape&, const RectangleShape&) = default;
};
/// A round bar.
struct CircleShape {
    double diameter = 0.0;  ///< m
    friend bool operator==(const CircleShape&, const CircleShape&) = default;
};
/// A round tube.
struct TubeShape {
    double outer_diameter = 0.0;  ///< m
    double inner_diameter = 0.0;  ///< m
    friend bool operator==(const TubeShape&, const TubeShape&) = default;
};
/// Two flanges, joined by a web in the middle that stands along axis 3.
struct IShape {
    double width = 0.0;             ///< width of the flanges
    double height = 0.0;            ///< overall height, flanges included
    double flange_thickness = 0.0;  ///< m
    double web_thickness = 0.0;     ///< m
    friend bool operator==(const IShape&, const IShape&) = default;
};
/// The shapes whose stresses are known.
using SectionShape = std::variant<RectangleShape, CircleShape, TubeShape, IShape>;

/// The cross-section of a beam. Local axis 1 runs along the beam, axis 3 is the beam's normal, axis 2 = axis
/// 3 x axis 1. The deformation of a beam depends on the numbers alone; its stress depends on the shape, too.
struct Section {
    double area = 0.0;  ///< m^2
    double I2 = 0.0;    ///< m^4; bending about axis 2: out of plane, for a beam in a flat pattern
    double I3 = 0.0;    ///< m^4; bending about axis 3: in the plane
    double J = 0.0;     ///< m^4; torsion constant
    std::optional<double>
        shear_area2{};  ///< m^2, for shear along axis 2; none: shear-rigid (Euler-Bernoulli)
    std::optional<double> shear_area3{};  ///< m^2, for shear along axis 3; none: shear-rigid
    /// The shape of the section. None means the rectangle of the same area and second moments. Files store
    /// the shape unless it is a rectangle.
    std::optional<SectionShape> shape{};
    friend bool operator==(const Section&, const Section&) = default;
};

/// The shape of a section; without one, the rectangle with the section's area and second moments.
SectionShape shape_of(const Section& section);
/// The name of a shape: "rectangle", "circle", "tube" or "I".
const char* shape_name(const SectionShape& shape);

/// The sides of the box around a section's shape, metres.
double section_width(const Section& section);   ///< along local axis 2
double section_height(const Section& section);  ///< along local axis 3

/// The sides of the rectangle with a section's area and second moments, metres.
double rectangle_width(const Section& section);   ///< along local axis 2
double rectangle_height(const Section& section);  ///< along local axis 3

/// A rectangle of `width` along local axis 2 and `height` along local axis 3 (metres); J is Saint-Venant's
/// series. Its `shape` stays empty, because the numbers define the rectangle.
Section rectangle_section(double width, double height);
/// The section of a round bar.
Section circle_section(double diameter);
/// The section of a round tube.
Section tube_section(double outer_diameter, double inner_diameter);
/// The section of an I shape. J is that of three thin plates without fillets, a third of the sum of length
/// times thickness cubed; warping is free.
Section i_section(const IShape& shape);
/// The section of a shape. Throws InputError if a length is not positive, or if lengths contradict each
/// other.
Section section_of(const SectionShape& shape);

}  // namespace fretwork::mechanics
