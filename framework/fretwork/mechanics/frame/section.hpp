// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <variant>

namespace fretwork::mechanics {

/// A rectangular bar. In this and the following shapes, widths lie along local axis 2 and heights along local
/// axis 3.
struct RectangleShape {
    double width = 0.0;   ///< width, in the pattern's plane, m
    double height = 0.0;  ///< height, across the pattern's plane, m
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
/// A bar of two flanges and a web, which stands along axis 3 in the middle of the flanges.
struct IShape {
    double width = 0.0;             ///< width of the flanges, m
    double height = 0.0;            ///< overall height, flanges included, m
    double flange_thickness = 0.0;  ///< m
    double web_thickness = 0.0;     ///< m
    friend bool operator==(const IShape&, const IShape&) = default;
};
/// The shapes with known stresses.
using SectionShape = std::variant<RectangleShape, CircleShape, TubeShape, IShape>;

/// The cross-section of a beam. Local axis 1 runs along the beam, axis 3 is the beam's normal, axis 2 = axis
/// 3 x axis 1. The deformation of a beam depends only on the areas and moments of its section; the stress
/// depends on the shape, too.
struct Section {
    double area = 0.0;  ///< m^2
    /// Second moment for bending about axis 2, m^4: out of the plane, for a beam in a flat pattern.
    double I2 = 0.0;
    double I3 = 0.0;                      ///< second moment for bending about axis 3, m^4: in the plane
    double J = 0.0;                       ///< torsion constant, m^4
    std::optional<double> shear_area2{};  ///< shear area along axis 2, m^2; none: shear-rigid
    std::optional<double> shear_area3{};  ///< shear area along axis 3, m^2; none: shear-rigid
    /// The shape of the section. None: the rectangle with the same radii of gyration. Files store the shape
    /// unless it is a rectangle or contradicts the numbers above.
    std::optional<SectionShape> shape{};
    friend bool operator==(const Section&, const Section&) = default;
};

/// The shape of a section; for a section without a shape, the rectangle with its radii of gyration.
SectionShape shape_of(const Section& section);
/// The name of a shape: "rectangle", "circle", "tube" or "I".
const char* shape_name(const SectionShape& shape);

/// The size of the box around a section's shape, m.
double section_width(const Section& section);   ///< along local axis 2
double section_height(const Section& section);  ///< along local axis 3

/// The size of the rectangle with a section's radii of gyration, m.
double rectangle_width(const Section& section);   ///< along local axis 2
double rectangle_height(const Section& section);  ///< along local axis 3

/// The section of a rectangle with `width` along local axis 2 and `height` along local axis 3, m. J is
/// Saint-Venant's series. Section::shape stays empty, because area and second moments define the rectangle.
/// Throws as section_of().
Section rectangle_section(double width, double height);
/// The section of a round bar; the diameter is in m. Throws as section_of().
Section circle_section(double diameter);
/// The section of a round tube; the diameters are in m. Throws as section_of().
Section tube_section(double outer_diameter, double inner_diameter);
/// The section of an I shape. J is the torsion constant of three thin plates without fillets, a third of the
/// sum of length times thickness cubed; warping is free. Throws as section_of().
Section i_section(const IShape& shape);
/// The section of a shape. Throws InputError if a length is not positive, or if lengths contradict each
/// other.
Section section_of(const SectionShape& shape);

}  // namespace fretwork::mechanics
