// SPDX-License-Identifier: GPL-3.0-or-later
#include "fixtures.hpp"

#include <fretwork/base/error.hpp>
#include <fretwork/reduction/effective_properties.hpp>

#include <Eigen/Cholesky>
#include <gtest/gtest.h>

#include <map>

namespace fretwork::reduction {
namespace THIS_TEST {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// "0-6" joins each center with its neighbours': a triangular lattice of bars, as long as two apothems. Under
/// strain its nodes do not turn, by symmetry, so bars stretch and shear as the plane does (closed form).
TEST(EffectiveProperties, OfATriangularLatticeAreItsClosedForm) {
    const Setting setting = paper_setting();
    const auto found = effective_properties(paper_layout(), paper_pattern("0-6"), setting);
    const double L = 0.045;
    const double area = std::sqrt(3.0) / 2.0 * L * L;
    const double E = setting.material.young_modulus;
    const mechanics::Section& bar = setting.section;
    Matrix3d A = Matrix3d::Zero();
    Matrix3d D = Matrix3d::Zero();
    for (int bond = 0; bond < 3; ++bond) {
        const double c = std::cos(bond * std::numbers::pi / 3.0 + std::numbers::pi / 2.0);
        const double s = std::sin(bond * std::numbers::pi / 3.0 + std::numbers::pi / 2.0);
        const Vector3d along(c * c, s * s, c * s);                    // n.e n
        const Vector3d across(-c * s, c * s, (c * c - s * s) / 2.0);  // t.e n
        A += L * L / area *
             (E * bar.area / L * along * along.transpose() +
              12.0 * E * bar.I3 / (L * L * L) * across * across.transpose());
        D += L / area *
             (E * bar.I2 * along * along.transpose() +
              setting.material.shear_modulus() * bar.J * across * across.transpose());
    }
    EXPECT_LT(relative_difference(found.A, A), 1e-9);
    EXPECT_LT(relative_difference(found.D, D), 1e-9);
    EXPECT_NEAR(found.mass_per_area, 1240.0 * 4e-6 * 3.0 * L / area, 1e-12);
}

/// A fourth-order tensor with a six-fold axis is isotropic.
TEST(EffectiveProperties, OfPatternsInHexagonsAreIsotropic) {
    for (const char* id : {"0-1+1-6", "1-6+3-6", "0-1+1-3+3-6"}) {
        const auto found = effective_properties(paper_layout(), paper_pattern(id), paper_setting());
        for (const Matrix3d& tensor : {found.A, found.D}) {
            const double stiffness = directional_stiffness(tensor, 0.0);
            for (const double angle : {0.3, 0.9, 1.7, 2.6}) {
                EXPECT_NEAR(directional_stiffness(tensor, angle), stiffness, 1e-7 * stiffness) << id;
            }
        }
    }
}

TEST(EffectiveProperties, OfASquareGridDependOnTheDirection) {
    Setting setting = paper_setting();
    setting.sides = 4;
    setting.scenarios.resize(1);
    const auto found = effective_properties(paper_layout(), paper_pattern("0-6"), setting);
    // A grid of bars along x and y: stiff along them, soft across the diagonal.
    const double along = directional_stiffness(found.A, 0.0);
    EXPECT_NEAR(along, 1e9 * 4e-6 / setting.tile_side, 1e-6 * along);
    EXPECT_GT(along, 10.0 * directional_stiffness(found.A, std::numbers::pi / 4.0));
}

TEST(EffectiveProperties, ArePositiveDefiniteAndNamed) {
    const auto found = effective_properties(paper_layout(), paper_pattern("0-1+1-6"), paper_setting());
    EXPECT_EQ(found.A.llt().info(), Eigen::Success);
    EXPECT_EQ(found.D.llt().info(), Eigen::Success);
    std::map<std::string, double> values;
    for (const auto& [name, value] : property_values(found)) values[name] = value;
    EXPECT_EQ(values.size(), 21U);
    EXPECT_EQ(values.at("A12"), found.A(0, 1));
    EXPECT_EQ(values.at("D66"), found.D(2, 2));
    EXPECT_NEAR(values.at("membrane_anisotropy"), 1.0, 1e-6);
    EXPECT_LT(std::abs(values.at("membrane_poisson")), 1.0);
    EXPECT_DOUBLE_EQ(values.at("bending_stiffness"), directional_stiffness(found.D, 0.0));
}

TEST(EffectiveProperties, NeedAPolygonThatTilesByTranslations) {
    Setting setting = paper_setting();
    setting.sides = 5;
    EXPECT_THROW((void)effective_properties(paper_layout(), paper_pattern("0-6"), setting), base::InputError);
}

}  // namespace THIS_TEST
}  // namespace fretwork::reduction
