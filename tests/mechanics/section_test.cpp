// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/mechanics/frame/frame.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace fretwork::mechanics {
namespace THIS_TEST {

TEST(Section, RectangleBendsOutOfPlaneByItsHeight) {
    const Section section = rectangle_section(0.002, 0.003);
    EXPECT_DOUBLE_EQ(section.area, 6e-6);
    EXPECT_DOUBLE_EQ(section.I2, 0.002 * std::pow(0.003, 3) / 12.0);
    EXPECT_DOUBLE_EQ(section.I3, 0.003 * std::pow(0.002, 3) / 12.0);
    EXPECT_FALSE(section.shear_area2);
}

// Timoshenko and Goodier, Theory of Elasticity, table of J / (a b^3): four digits are printed for 1.5 to 10;
// the square's constant is known to more.
TEST(Section, RectangleTorsionIsSaintVenants) {
    EXPECT_NEAR(rectangle_section(1.0, 1.0).J, 0.1405770, 5e-8);
    EXPECT_NEAR(rectangle_section(1.5, 1.0).J, 0.1958 * 1.5, 1e-4);
    EXPECT_NEAR(rectangle_section(2.0, 1.0).J, 0.2287 * 2.0, 1e-4);
    EXPECT_NEAR(rectangle_section(10.0, 1.0).J, 0.3123 * 10.0, 1e-3);
    EXPECT_DOUBLE_EQ(rectangle_section(1.0, 3.0).J, rectangle_section(3.0, 1.0).J);
}

TEST(Section, CircleAndTubeAreClosedForms) {
    const Section circle = circle_section(0.002);
    EXPECT_DOUBLE_EQ(circle.area, std::numbers::pi * 1e-6);
    EXPECT_DOUBLE_EQ(circle.I2, std::numbers::pi * std::pow(0.002, 4) / 64.0);
    EXPECT_DOUBLE_EQ(circle.J, 2.0 * circle.I3);
    const Section tube = tube_section(0.004, 0.003);
    EXPECT_NEAR(tube.I2, std::numbers::pi / 64.0 * (256e-12 - 81e-12), 1e-24);
    EXPECT_NEAR(tube.area, std::numbers::pi / 4.0 * 7e-6, 1e-18);
}

TEST(Section, AnIIsTwoFlangesAndAWeb) {
    const Section section = i_section({0.05, 0.1, 0.005, 0.004});
    EXPECT_NEAR(section.area, 2 * 0.05 * 0.005 + 0.09 * 0.004, 1e-15);
    // The rule of parallel axes.
    EXPECT_NEAR(section.I2,
                2 * (0.05 * std::pow(0.005, 3) / 12 + 0.05 * 0.005 * std::pow(0.0475, 2)) +
                    0.004 * std::pow(0.09, 3) / 12,
                1e-18);
    EXPECT_NEAR(section.I3, 2 * 0.005 * std::pow(0.05, 3) / 12 + 0.09 * std::pow(0.004, 3) / 12, 1e-18);
    EXPECT_EQ(section_width(section), 0.05);
    EXPECT_EQ(section_height(section), 0.1);
}

TEST(Section, KeepsItsShape) {
    EXPECT_STREQ(shape_name(shape_of(tube_section(0.004, 0.003))), "tube");
    EXPECT_EQ(section_width(circle_section(0.002)), 0.002);
    const SectionShape taken = shape_of(rectangle_section(0.002, 0.003));
    EXPECT_STREQ(shape_name(taken), "rectangle");
    EXPECT_NEAR(std::get<RectangleShape>(taken).height, 0.003, 1e-15);
}

TEST(Section, ImpossibleSizesAreRefused) {
    EXPECT_THROW(i_section({0.05, 0.1, 0.05, 0.004}), base::InputError);
    EXPECT_THROW(i_section({0.05, 0.1, 0.005, 0.06}), base::InputError);
    EXPECT_THROW(rectangle_section(0.0, 1.0), base::InputError);
    EXPECT_THROW(rectangle_section(1.0, std::numeric_limits<double>::quiet_NaN()), base::InputError);
    EXPECT_THROW(circle_section(-1.0), base::InputError);
    EXPECT_THROW(tube_section(1.0, 1.0), base::InputError);
}

}  // namespace THIS_TEST
}  // namespace fretwork::mechanics
