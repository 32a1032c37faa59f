// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/geometry/rotation.hpp>
#include <fretwork/reduction/detail/rotation.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace fretwork::reduction::detail {
namespace THIS_TEST {

constexpr double kQuarter = std::numbers::pi / 2.0;
/// A few roundings.
constexpr double kTolerance = 5e-15;

/// Angles of all sizes from 0 to pi/2, both included, close to either end as well.
std::vector<double> angles() {
    std::vector<double> result = {0.0, 1e-300, 1e-160, 1e-20, kQuarter};
    for (int power = -15; power < 0; ++power) {
        result.push_back(std::pow(10.0, power));
        result.push_back(kQuarter - std::pow(10.0, power));
    }
    for (int i = 1; i < 100; ++i) result.push_back(kQuarter * i / 100.0);
    return result;
}

TEST(AngleSum, OfOneAngleIsItsArctangent) {
    for (const double angle : angles()) {
        const double sine = std::sin(angle);
        const double cosine = std::abs(std::cos(angle));
        AngleSum sum;
        sum.add(sine, cosine);
        EXPECT_DOUBLE_EQ(sum.value(), std::atan2(sine, cosine));
    }
}

TEST(AngleSum, HasARelativeErrorOfAFewRoundingsForAnyAngles) {
    for (const double a : angles()) {
        for (const double b : angles()) {
            for (const double c : {1e-12, 0.7, kQuarter}) {
                AngleSum sum;
                double expected = 0.0;
                for (const double angle : {a, b, a, c, b, b}) {
                    const double sine = std::sin(angle);
                    const double cosine = std::abs(std::cos(angle));
                    sum.add(sine, cosine);
                    expected += std::atan2(sine, cosine);
                }
                EXPECT_NEAR(sum.value(), expected, kTolerance * expected) << a << ", " << b << ", " << c;
            }
        }
    }
}

TEST(AngleSum, CountsExactQuarterTurns) {
    AngleSum sum;
    for (int i = 1; i <= 9; ++i) {
        sum.add(1.0, 0.0);
        EXPECT_DOUBLE_EQ(sum.value(), i * kQuarter);
    }
    sum.add(0.0, 1.0);
    EXPECT_DOUBLE_EQ(sum.value(), 9 * kQuarter);
}

TEST(AngleSum, OfNothingIsZero) {
    AngleSum sum;
    EXPECT_EQ(sum.value(), 0.0);
    sum.add(0.0, 1.0);
    EXPECT_EQ(sum.value(), 0.0);
}

/// Rotation vectors for a magnitude of 1: none, tiny, usual, several turns.
std::vector<Eigen::Vector3d> rates() {
    const Eigen::Vector3d direction(0.3, -1.1, 0.7);
    return {Eigen::Vector3d::Zero(), 1e-150 * direction, 1e-9 * direction, 1e-4 * direction,
            0.2 * direction,         3.0 * direction,    {0.0, 0.0, 0.5},  {0.0, 0.0, -kQuarter * 2}};
}

TEST(GrowingRotation, IsTheRotationOfTheGrownVector) {
    for (const Eigen::Vector3d& rate : rates()) {
        GrowingRotation growing(rate);
        EXPECT_EQ(growing.rotation().coeffs(), Eigen::Quaterniond::Identity().coeffs());
        double magnitude = 0.0;
        for (const double step : {0.1, 0.25}) {
            growing.set_step(step);
            for (int k = 0; k < 10; ++k) {
                growing.advance();
                magnitude += step;
                const Eigen::Vector3d vector = magnitude * rate;
                const Eigen::Vector4d difference =
                    growing.rotation().coeffs() - geometry::exponential(vector).coeffs();
                EXPECT_LT(difference.norm(), kTolerance * (1.0 + vector.norm()));
                // The imaginary part is exact relative to itself, however small.
                EXPECT_LE(difference.head<3>().norm(), kTolerance * vector.norm());
            }
        }
    }
}

TEST(GrowingRotation, JacobianAgreesWithFiniteDifferences) {
    for (const Eigen::Vector3d& rate : rates()) {
        GrowingRotation growing(rate);
        growing.set_step(0.5);
        for (int k = 1; k <= 2; ++k) {
            growing.advance();
            const Eigen::Vector3d v = 0.5 * k * rate;
            Eigen::Matrix3d transposed;
            for (int i = 0; i < 3; ++i) transposed.col(i) = growing.pull_back(Eigen::Vector3d::Unit(i));
            for (int i = 0; i < 3; ++i) {
                constexpr double kStep = 1e-5;
                const Eigen::Vector3d e = kStep * Eigen::Vector3d::Unit(i);
                const auto change = [&](const Eigen::Vector3d& moved) {
                    return geometry::logarithm(geometry::exponential(v).conjugate() *
                                               geometry::exponential(moved));
                };
                const Eigen::Vector3d slope = (change(v + e) - change(v - e)) / (2.0 * kStep);
                EXPECT_LT((transposed.row(i).transpose() - slope).norm(), 1e-9) << v.transpose();
            }
            const Eigen::Vector3d axis = v.stableNormalized();
            const Eigen::Matrix3d along = axis * axis.transpose();
            const Eigen::Matrix3d square =
                growing.squared_rate_across() * (Eigen::Matrix3d::Identity() - along) + along;
            EXPECT_LT((transposed * transposed.transpose() - square).norm(), kTolerance);
        }
    }
}

}  // namespace THIS_TEST
}  // namespace fretwork::reduction::detail
