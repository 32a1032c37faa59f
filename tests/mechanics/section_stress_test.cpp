// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/mechanics/results/section_stress.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace fretwork::mechanics {
namespace THIS_TEST {

constexpr double kPi = std::numbers::pi;

SectionStress stress_of(const Section& section, const SectionForces& forces) {
    return SectionPoints(section).largest(forces);
}

// Timoshenko and Goodier, Theory of Elasticity, 109: the largest shear is T / (k2 a b^2), for a >= b; the
// table prints three digits.
TEST(SectionStress, TorsionOfARectangleIsSaintVenants) {
    const auto constant = [](double a, double b) {
        return 1.0 / (stress_of(rectangle_section(a, b), {.T = 1.0}).shear * a * b * b);
    };
    EXPECT_NEAR(constant(1.0, 1.0), 0.208, 5e-4);
    EXPECT_NEAR(constant(1.5, 1.0), 0.231, 5e-4);
    EXPECT_NEAR(constant(2.0, 1.0), 0.246, 5e-4);
    EXPECT_NEAR(constant(3.0, 1.0), 0.267, 5e-4);
    EXPECT_NEAR(constant(10.0, 1.0), 0.312, 1e-3);
    EXPECT_DOUBLE_EQ(stress_of(rectangle_section(1.0, 3.0), {.T = 1.0}).shear,
                     stress_of(rectangle_section(3.0, 1.0), {.T = 1.0}).shear);
}

TEST(SectionStress, ShearOfARectangleIsLargestInTheMiddle) {
    const SectionStress stress = stress_of(rectangle_section(0.002, 0.003), {.V2 = 3.0, .V3 = 4.0});
    EXPECT_NEAR(stress.shear, 1.5 * 5.0 / 6e-6, 1e-6);
    EXPECT_EQ(stress.normal, 0.0);
}

TEST(SectionStress, TorsionAddsToShearOnOneSideOfARectangle) {
    const Section section = rectangle_section(0.002, 0.002);
    const double torsion = stress_of(section, {.T = 0.001}).shear;
    const double shear = stress_of(section, {.V3 = 2.0}).shear;
    for (const double sign : {-1.0, 1.0})
        EXPECT_NEAR(stress_of(section, {.V3 = 2.0, .T = 0.001 * sign}).shear, torsion + shear,
                    1e-6 * torsion);
}

TEST(SectionStress, VonMisesOfOneNormalStressIsItself) {
    for (const Section& section : {rectangle_section(0.002, 0.003), circle_section(0.002),
                                   tube_section(0.004, 0.003), i_section({0.01, 0.02, 0.001, 0.001})}) {
        const SectionStress stress = stress_of(section, {.N = -3.0, .M2 = 0.01, .M3 = -0.02});
        EXPECT_DOUBLE_EQ(stress.von_mises, stress.normal);
        EXPECT_EQ(stress.shear, 0.0);
    }
}

// The design of shafts: 32 sqrt(M^2 + 3/4 T^2) / (pi d^3).
TEST(SectionStress, ARoundShaftBendsAndTwists) {
    const double d = 0.002;
    const SectionStress stress = stress_of(circle_section(d), {.T = 0.03, .M2 = 0.02});
    const double unit = 32.0 / (kPi * d * d * d);
    EXPECT_NEAR(stress.normal, 0.02 * unit, 1e-9 * unit);
    EXPECT_NEAR(stress.shear, 0.03 * unit / 2.0, 1e-9 * unit);
    EXPECT_NEAR(stress.von_mises, std::sqrt(0.02 * 0.02 + 0.75 * 0.03 * 0.03) * unit, 1e-9 * unit);
}

// As the rectangle of the same area and second moment a round bar would have 0.866 of its stress.
TEST(SectionStress, ARoundBarIsNoRectangle) {
    Section numbers = circle_section(0.002);
    const double round = stress_of(numbers, {.M2 = 0.02}).normal;
    numbers.shape.reset();
    EXPECT_NEAR(stress_of(numbers, {.M2 = 0.02}).normal / round, std::sqrt(3.0) / 2.0, 1e-12);
}

TEST(SectionStress, ThinTubesBearTwiceTheirMeanShear) {
    const Section thin = tube_section(0.01, 0.00999);
    EXPECT_NEAR(stress_of(thin, {.V2 = 1.0}).shear * thin.area, 2.0, 1e-3);
    const Section thick = tube_section(0.01, 1e-6);
    EXPECT_NEAR(stress_of(thick, {.V3 = 1.0}).shear * thick.area, 4.0 / 3.0, 1e-3);
}

// Equilibrium: the shear of the web integrates to nearly the whole force, by Simpson's rule over the values
// at its ends and in its middle; the flanges bear the rest.
TEST(SectionStress, PowerSumsComeNearTheLargestStress) {
    const SectionForces forces{.N = 3.0, .V2 = -1.0, .V3 = 0.5, .T = 0.001, .M2 = 0.002, .M3 = -0.001};
    for (const Section& section : {rectangle_section(0.002, 0.003), circle_section(0.002)}) {
        const SectionPoints points(section);
        const double largest = points.largest(forces).von_mises;
        const double sum = points.power_sum(forces, {.reference = largest, .exponent = 2000.0}).value;
        EXPECT_NEAR(sum, 1.0, 1e-3) << "one point of them all";
    }
}

// By differences of fourth order.
TEST(SectionStress, PowerSumsHaveTheirGradient) {
    const Eigen::Vector<double, 6> at(3.0, -1.0, 0.5, 0.001, 0.002, -0.001);
    const auto forces = [](const Eigen::Vector<double, 6>& f) {
        return SectionForces{.N = f[0], .V2 = f[1], .V3 = f[2], .T = f[3], .M2 = f[4], .M3 = f[5]};
    };
    for (const Section& section : {rectangle_section(0.002, 0.003), tube_section(0.004, 0.003),
                                   i_section({0.01, 0.02, 0.001, 0.001})}) {
        const SectionPoints points(section);
        const SectionPoints::Power power{points.largest(forces(at)).von_mises, 8.0};
        const auto gradient = points.power_sum(forces(at), power).gradient;
        for (Eigen::Index i = 0; i < 6; ++i) {
            const auto value = [&](double share) {
                Eigen::Vector<double, 6> moved = at;
                moved[i] *= 1.0 + share;
                return points.power_sum(forces(moved), power).value;
            };
            const double h = 1e-3;
            const double wanted =
                (8.0 * (value(h) - value(-h)) - (value(2.0 * h) - value(-2.0 * h))) / (12.0 * h);
            EXPECT_NEAR(gradient[i] * at[i], wanted, 1e-8 * gradient.cwiseProduct(at).norm());
        }
    }
    EXPECT_EQ(SectionPoints(circle_section(0.002)).power_sum({}, {}).gradient.norm(), 0.0);
}

TEST(SectionStress, TheWebOfAnIBearsItsShearForce) {
    const IShape shape{.width = 0.05, .height = 0.1, .flange_thickness = 0.005, .web_thickness = 0.004};
    const Section section = i_section(shape);
    const double largest = stress_of(section, {.V3 = 1.0}).shear;
    const double clear = 0.09;
    const double step = clear * clear / (8.0 * section.I2);  // from the ends to the middle of the web
    EXPECT_NEAR((largest - step / 3.0) * shape.web_thickness * clear, 0.97, 0.03);
    const SectionStress bent = stress_of(section, {.M2 = 1.0});
    EXPECT_NEAR(bent.normal, 0.05 / section.I2, 1e-9 * bent.normal);
    EXPECT_NEAR(stress_of(section, {.T = 1.0}).shear, 0.005 / section.J, 1e-9 / section.J);
}

}  // namespace THIS_TEST
}  // namespace fretwork::mechanics
