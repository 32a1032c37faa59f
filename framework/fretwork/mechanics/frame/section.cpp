// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/mechanics/frame/section.hpp>

#include <algorithm>
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
/// 31/32 zeta(5) less terms that fall off exponentially.
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
            .J = 2.0 * inertia};
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
            .J = outer.J - inner.J};
}

}  // namespace fretwork::mechanics
