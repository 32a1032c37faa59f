// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/mechanics/frame/section.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>

namespace fretwork::mechanics {
namespace {

void require_positive(double value, const char* what) {
    if (std::isfinite(value) && value > 0) return;
    throw base::InputError(std::string(what) + " is " + base::format_number(value) +
                           " m, where a length above zero is needed");
}

/// Saint-Venant's torsion constant of a solid rectangle (Timoshenko and Goodier, Theory of Elasticity, 109):
/// J = a b^3 (1/3 - 64 b / (pi^5 a) sum over odd n of tanh(n pi a / 2b) / n^5), a >= b. The sum is written as
/// 31/32 zeta(5) minus terms that decay exponentially.
double rectangle_torsion_constant(double width, double height) {
    const double a = std::max(width, height);
    const double b = std::min(width, height);
    constexpr double kZeta5 = 1.0369277551433699;
    double sum = 31.0 / 32.0 * kZeta5;
    for (int n = 1; n < 20; n += 2) {
        sum -= 2.0 / (std::exp(n * std::numbers::pi * a / b) + 1.0) / std::pow(n, 5);
    }
    return a * b * b * b * (1.0 / 3.0 - 64.0 / std::pow(std::numbers::pi, 5) * b / a * sum);
}

}  // namespace

double rectangle_width(const Section& section) {
    return std::sqrt(12.0 * section.I3 / section.area);
}

double rectangle_height(const Section& section) {
    return std::sqrt(12.0 * section.I2 / section.area);
}

Section rectangle_section(double width, double height) {
    require_positive(width, "the width of a rectangle");
    require_positive(height, "the height of a rectangle");
    return {.area = width * height,
            .I2 = width * std::pow(height, 3) / 12.0,
            .I3 = height * std::pow(width, 3) / 12.0,
            .J = rectangle_torsion_constant(width, height)};
}

Section circle_section(double diameter) {
    require_positive(diameter, "the diameter of a circle");
    const double inertia = std::numbers::pi * std::pow(diameter, 4) / 64.0;
    return {.area = std::numbers::pi * diameter * diameter / 4.0,
            .I2 = inertia,
            .I3 = inertia,
            .J = 2.0 * inertia,
            .shape = CircleShape{diameter}};
}

Section tube_section(double outer_diameter, double inner_diameter) {
    require_positive(outer_diameter, "the outer diameter of a tube");
    require_positive(inner_diameter, "the inner diameter of a tube");
    if (inner_diameter >= outer_diameter) {
        throw base::InputError("the inner diameter of a tube is " + base::format_number(inner_diameter) +
                               " m, which is not below the outer one, " +
                               base::format_number(outer_diameter) + " m");
    }
    const Section outer = circle_section(outer_diameter);
    const Section inner = circle_section(inner_diameter);
    return {.area = outer.area - inner.area,
            .I2 = outer.I2 - inner.I2,
            .I3 = outer.I3 - inner.I3,
            .J = outer.J - inner.J,
            .shape = TubeShape{outer_diameter, inner_diameter}};
}

Section i_section(const IShape& shape) {
    require_positive(shape.width, "the width of an I");
    require_positive(shape.height, "the height of an I");
    require_positive(shape.flange_thickness, "the flange thickness of an I");
    require_positive(shape.web_thickness, "the web thickness of an I");
    const double clear = shape.height - 2.0 * shape.flange_thickness;  // clear height between the flanges
    if (!(clear > 0.0))
        throw base::InputError("the two flanges of an I fill its height of " +
                               base::format_number(shape.height) + " m");
    if (shape.web_thickness > shape.width)
        throw base::InputError("the web thickness of an I is " + base::format_number(shape.web_thickness) +
                               " m, which is above its width, " + base::format_number(shape.width) + " m");
    const double beside = shape.width - shape.web_thickness;
    return {.area = shape.width * shape.height - beside * clear,
            .I2 = (shape.width * std::pow(shape.height, 3) - beside * std::pow(clear, 3)) / 12.0,
            .I3 = (2.0 * shape.flange_thickness * std::pow(shape.width, 3) +
                   clear * std::pow(shape.web_thickness, 3)) /
                  12.0,
            .J = (2.0 * shape.width * std::pow(shape.flange_thickness, 3) +
                  (shape.height - shape.flange_thickness) * std::pow(shape.web_thickness, 3)) /
                 3.0,
            .shape = shape};
}

Section section_of(const SectionShape& shape) {
    if (const auto* rectangle = std::get_if<RectangleShape>(&shape))
        return rectangle_section(rectangle->width, rectangle->height);
    if (const auto* circle = std::get_if<CircleShape>(&shape)) return circle_section(circle->diameter);
    if (const auto* tube = std::get_if<TubeShape>(&shape))
        return tube_section(tube->outer_diameter, tube->inner_diameter);
    return i_section(std::get<IShape>(shape));
}

SectionShape shape_of(const Section& section) {
    return section.shape.value_or(RectangleShape{rectangle_width(section), rectangle_height(section)});
}

const char* shape_name(const SectionShape& shape) {
    constexpr std::array<const char*, std::variant_size_v<SectionShape>> kNames = {"rectangle", "circle",
                                                                                   "tube", "I"};
    return kNames[shape.index()];
}

double section_width(const Section& section) {
    const SectionShape shape = shape_of(section);
    if (const auto* circle = std::get_if<CircleShape>(&shape)) return circle->diameter;
    if (const auto* tube = std::get_if<TubeShape>(&shape)) return tube->outer_diameter;
    if (const auto* profile = std::get_if<IShape>(&shape)) return profile->width;
    return std::get<RectangleShape>(shape).width;
}

double section_height(const Section& section) {
    const SectionShape shape = shape_of(section);
    if (const auto* profile = std::get_if<IShape>(&shape)) return profile->height;
    if (const auto* rectangle = std::get_if<RectangleShape>(&shape)) return rectangle->height;
    return section_width(section);
}

}  // namespace fretwork::mechanics
