// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/geometry/rotation.hpp>

#include <gtest/gtest.h>

namespace fretwork::geometry {
namespace THIS_TEST {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// Angles on both sides of the switch between series and closed form, and large ones.
constexpr double kAngles[] = {0.0, 1e-9, 1e-4, 0.1, 0.199, 0.201, 1.0, 3.0, 5.0};
const Vector3d kAxis = Vector3d(1.0, -2.0, 0.5).normalized();

TEST(Rotation, ExponentialTurnsAboutTheAxisByTheAngle) {
    for (const double angle : kAngles) {
        const Matrix3d expected = Eigen::AngleAxisd(angle, kAxis).toRotationMatrix();
        EXPECT_LT((exponential(angle * kAxis).toRotationMatrix() - expected).norm(), 1e-14) << angle;
    }
}

TEST(Rotation, LogarithmInvertsTheExponentialUpToHalfATurn) {
    for (const double angle : {0.0, 1e-9, 0.1, 1.0, 3.0, 3.14159})
        EXPECT_LT((logarithm(exponential(angle * kAxis)) - angle * kAxis).norm(), 1e-13) << angle;
}

TEST(Rotation, NearestLogarithmFollowsTwoFullTurnsWithoutAJump) {
    Vector3d vector = Vector3d::Zero();
    for (int step = 1; step <= 100; ++step) {
        const double angle = 4.0 * std::numbers::pi * step / 100.0;
        const Vector3d next = logarithm_near(exponential(angle * kAxis), vector);
        EXPECT_LT((next - angle * kAxis).norm(), 1e-12);
        vector = next;
    }
}

TEST(Rotation, SpinMapIsTheDerivativeOfTheRotation) {
    const Vector3d direction(0.3, 0.7, -0.4);
    constexpr double kStep = 1e-6;
    for (const double angle : kAngles) {
        const Vector3d v = angle * kAxis;
        const Eigen::Quaterniond turn =
            exponential(v + kStep * direction) * exponential(v - kStep * direction).conjugate();
        const Vector3d difference = logarithm(turn) / (2.0 * kStep);
        EXPECT_LT((spin_map(v) * direction - difference).norm(), 1e-9) << angle;
    }
}

TEST(Rotation, InverseSpinMapUndoesTheSpinMap) {
    for (const double angle : {0.0, 1e-6, 0.01, 0.19, 0.21, 1.0, 3.0, 5.0}) {
        const Vector3d v = angle * kAxis;
        // The map loses digits on the way to a whole turn, where it is singular.
        EXPECT_LT((inverse_spin_map(v) * spin_map(v) - Matrix3d::Identity()).norm(), 1e-13) << angle;
    }
}

TEST(Rotation, DerivativeOfTheSpinMapAgreesWithFiniteDifferences) {
    const Vector3d a(0.9, -0.2, 0.6);
    constexpr double kStep = 1e-6;
    for (const double angle : kAngles) {
        Matrix3d difference;
        for (int i = 0; i < 3; ++i) {
            const Vector3d shift = kStep * Vector3d::Unit(i);
            difference.col(i) = (spin_map(angle * kAxis + shift).transpose() * a -
                                 spin_map(angle * kAxis - shift).transpose() * a) /
                                (2.0 * kStep);
        }
        EXPECT_LT((spin_map_derivative(angle * kAxis, a) - difference).norm(), 1e-9) << angle;
    }
}

TEST(RigidMotions, AreATranslationAndARotationAboutTheOrigin) {
    const Eigen::Vector3d translation(0.1, -0.2, 0.3);
    const Eigen::Vector3d rotation(0.4, 0.5, -0.6);
    Eigen::Matrix3Xd points(3, 2);
    points << 1.0, 0.2, -2.0, 0.5, 3.0, 0.0;
    Eigen::Matrix<double, 6, 1> motion;
    motion << translation, rotation;
    const Eigen::VectorXd rows = rigid_motions(points) * motion;
    for (int i = 0; i < 2; ++i) {
        const Eigen::Vector3d expected = translation + rotation.cross(points.col(i));
        EXPECT_LT((rows.segment<3>(6 * i) - expected).norm(), 1e-15);
        EXPECT_EQ(rows.segment<3>(6 * i + 3), rotation);
    }
}

}  // namespace THIS_TEST
}  // namespace fretwork::geometry
