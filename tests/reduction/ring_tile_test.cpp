// SPDX-License-Identifier: GPL-3.0-or-later
#include "fixtures.hpp"

#include <fretwork/base/error.hpp>
#include <fretwork/mechanics/linear_solver.hpp>
#include <fretwork/reduction/models/condensed_tile.hpp>
#include <fretwork/reduction/ring/ring_tile.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace fretwork::reduction {
namespace THIS_TEST {

/// The tile in the setting's own polygon.
mechanics::Frame regular_tile(const RingParts& parts, const Setting& setting) {
    return ring_tile(parts, paper_layout(), setting,
                     geometry::regular_polygon(setting.sides, setting.tile_side));
}

/// The tile as any other frame, solved by the general solver, for 1 N.
mechanics::NodeValues solved_tile(const RingParts& parts, const Setting& setting, std::size_t s) {
    Scenario scenario = setting.scenarios[s];
    scenario.max_magnitude = 1.0;
    const auto frame = scenario_frame(regular_tile(parts, setting), scenario);
    return mechanics::solve_linear(mechanics::assemble(frame)).displacements.topRows(6);
}

TEST(RingHexagon, EqualsTheTileUnderTheGeneralSolver) {
    const Setting setting = paper_setting();
    const RingHexagon hexagon(setting);
    base::RandomStream random(1, 0);
    for (int trial = 0; trial < 40; ++trial) {
        const RingParts parts = random_parts(setting, random);
        const UnitDisplacements fast = hexagon.displacements(parts);
        for (std::size_t s = 0; s < 5; ++s) {
            // Both are backward stable; stiffnesses differ by up to 1e9 here.
            EXPECT_LT(relative_difference(fast[s], solved_tile(parts, setting, s)), 1e-7)
                << "trial " << trial << ", " << setting.scenarios[s].name;
        }
    }
}

TEST(RingHexagon, StaysAccurateAtTheBounds) {
    const Setting setting = paper_setting();
    const RingHexagon hexagon(setting);
    const RingBounds bounds = ring_bounds(setting);
    const auto low = Paper6Parameters::of(bounds.lower);
    const auto high = Paper6Parameters::of(bounds.upper);
    const mechanics::Section& bar = setting.section;
    struct Corner {
        Paper6Parameters parameters;
        double tolerance;
    };
    // Links or ring beams of a hundredth of the usual length are 1e6 times as stiff, of a thousandth 1e9
    // times: what round-off leaves of the soft modes shrinks accordingly, in either solver. In the first
    // corner A / (I2 / L^2) is 1e9 as well, and rounding the stiffnesses alone (1e-16) moves the answers by
    // 1e-7.
    const Corner corners[] = {
        {{high.A, low.I2, low.I3, low.J, high.theta, 0.5 * high.R}, 1e-6},
        {{low.A, high.I2, high.I3, high.J, low.theta, 0.5 * high.R}, 1e-7},
        {{bar.area, bar.I2, bar.I3, bar.J, high.theta, 10.0 * low.R}, 1e-7},
        {{bar.area, bar.I2, bar.I3, bar.J, 0.0, high.R}, 1e-4},
    };
    for (const auto& [parameters, tolerance] : corners) {
        const UnitDisplacements fast = hexagon.displacements(parameters);
        for (std::size_t s = 0; s < 5; ++s) {
            EXPECT_LT(relative_difference(fast[s], solved_tile(parameters, setting, s)), tolerance);
        }
    }
}

TEST(RingHexagon, DerivativesAgreeWithFiniteDifferences) {
    const Setting setting = paper_setting();
    const RingHexagon hexagon(setting);
    base::RandomStream random(2, 0);
    for (int trial = 0; trial < 5; ++trial) {
        const RingParts center = random_parts(setting, random);
        RingParts rates = center;
        rates[kRingTheta] = 1.0;
        const RingDirections directions = rates.asDiagonal();
        const auto exact = hexagon.derivatives(center, directions);
        for (int p = 0; p < kRingParts; ++p) {
            const auto displaced = [&](double share) {
                return hexagon.displacements(center + share * directions.col(p));
            };
            constexpr double kStep = 1e-5;
            const auto ahead = displaced(kStep);
            const auto behind = displaced(-kStep);
            for (std::size_t s = 0; s < 5; ++s) {
                const mechanics::NodeValues slope = (ahead[s] - behind[s]) / (2.0 * kStep);
                const Eigen::VectorXd flat = slope.reshaped<Eigen::RowMajor>();
                const Eigen::VectorXd analytic = exact.derivatives[s].col(p);
                EXPECT_LT((flat - analytic).norm(), 1e-5 * (exact.displacements[s].norm() + analytic.norm()))
                    << "part " << ring10_parameters().names[static_cast<std::size_t>(p)];
            }
        }
    }
}

TEST(RingHexagon, DerivativesComeWithTheSameDisplacements) {
    const Setting setting = paper_setting();
    const RingHexagon hexagon(setting);
    base::RandomStream random(3, 0);
    const RingParts parts = random_parts(setting, random);
    const auto plain = hexagon.displacements(parts);
    const auto both = hexagon.derivatives(parts, paper6_parameters().ties);
    for (std::size_t s = 0; s < 5; ++s) EXPECT_EQ(plain[s], both.displacements[s]);
}

TEST(RingHexagon, AdjointGradientIsTheSumOverAllDerivatives) {
    const Setting setting = paper_setting();
    const RingHexagon hexagon(setting);
    base::RandomStream random(4, 0);
    const RingParts parts = random_parts(setting, random);
    UnitDisplacements slopes(5, mechanics::NodeValues(6, 6));
    for (auto& of_scenario : slopes) {
        for (double& slope : of_scenario.reshaped()) slope = random.uniform() - 0.5;
    }
    UnitDisplacements seen;
    const RingParts adjoint = hexagon.gradient(parts, [&](const UnitDisplacements& displacements) {
        seen = displacements;
        return slopes;
    });
    EXPECT_EQ(seen, hexagon.displacements(parts));
    const auto forward = hexagon.derivatives(parts, RingDirections::Identity(kRingParts, kRingParts));
    RingParts sum = RingParts::Zero();
    RingParts size = RingParts::Zero();
    for (std::size_t s = 0; s < 5; ++s) {
        const Eigen::VectorXd flat = slopes[s].reshaped<Eigen::RowMajor>();
        sum += forward.derivatives[s].transpose() * flat;
        size += forward.derivatives[s].cwiseAbs().transpose() * flat.cwiseAbs();
    }
    // Two ways through one factorization: what round-off leaves grows with its conditioning, up to some 1e6.
    for (int p = 0; p < kRingParts; ++p) EXPECT_NEAR(adjoint[p], sum[p], 1e-9 * size[p]) << "part " << p;
}

TEST(RingHexagon, RefusesMechanismsAndPolygonsOtherThanHexagons) {
    Setting setting = paper_setting();
    setting.scenarios[2].supports.resize(1);
    setting.scenarios[2].supports[0].fixed = mechanics::DofSet::translations();
    try {
        const RingHexagon hexagon(setting);
        FAIL() << "bending about a single hinge";
    } catch (const base::InputError& error) {
        EXPECT_THAT(error.what(), testing::HasSubstr("bending"));
    }
    setting = paper_setting();
    setting.sides = 7;
    EXPECT_THROW(RingHexagon{setting}, base::InputError);
}

TEST(RingHexagon, HoldsATileOfAnySize) {
    for (const double factor : {1e-4, 1e-2, 1e3}) {
        Setting setting = paper_setting();
        setting.tile_side *= factor;
        setting.section = mechanics::rectangle_section(0.002 * factor, 0.002 * factor);
        EXPECT_NO_THROW(RingHexagon{setting}) << "times " << factor;
    }
}

/// A change of one section of the paper's model is the sum of that of the links and that of the ring.
TEST(RingHexagon, DerivativesOfSharedSectionsAreSums) {
    const Setting setting = paper_setting();
    const RingHexagon hexagon(setting);
    base::RandomStream random(5, 0);
    const RingParts parts = random_parameters(setting, random);
    const auto apart = hexagon.derivatives(parts, ring10_parameters().ties);
    const auto shared = hexagon.derivatives(parts, paper6_parameters().ties);
    for (std::size_t s = 0; s < 5; ++s) {
        const Eigen::MatrixXd sums = apart.derivatives[s] * paper6_parameters().ties;
        for (int k = 0; k < 6; ++k) {
            const Eigen::VectorXd difference = sums.col(k) - shared.derivatives[s].col(k);
            EXPECT_LE(difference.norm(), 1e-9 * shared.derivatives[s].col(k).norm())
                << paper6_parameters().names[static_cast<std::size_t>(k)];
        }
    }
}

TEST(RingTile, StiffnessIsInvariantUnderATurnBy60Degrees) {
    const Setting setting = paper_setting();
    base::RandomStream random(4, 0);
    const Eigen::MatrixXd K = condensed_frame(regular_tile(random_parts(setting, random), setting), 6);
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(std::numbers::pi / 3.0, Eigen::Vector3d::UnitZ()).matrix();
    // Node i goes to node i + 1, and its components turn.
    Eigen::MatrixXd T = Eigen::MatrixXd::Zero(36, 36);
    for (int node = 0; node < 6; ++node) {
        T.block<3, 3>(6 * ((node + 1) % 6), 6 * node) = turn;
        T.block<3, 3>(6 * ((node + 1) % 6) + 3, 6 * node + 3) = turn;
    }
    EXPECT_LT(relative_difference(T * K * T.transpose(), K), 1e-9);
}

TEST(RingTile, RingLiesAtThetaAndRInTheHexagon) {
    const Setting setting = paper_setting();
    const Paper6Parameters parameters{1e-6, 1e-12, 1e-12, 1e-12, 0.3, 0.011};
    const auto frame = regular_tile(parameters, setting);
    ASSERT_EQ(frame.nodes.size(), 12U);
    ASSERT_EQ(frame.beams.size(), 12U);
    for (int k = 0; k < 6; ++k) {
        const double angle = (270.0 + 60.0 * k) * std::numbers::pi / 180.0 + 0.3;
        const Eigen::Vector3d expected(0.011 * std::cos(angle), 0.011 * std::sin(angle), 0.0);
        EXPECT_LT((frame.nodes[static_cast<std::size_t>(6 + k)] - expected).norm(), 1e-15);
    }
}

/// Barycentric places are affine: a stretched hexagon has the stretched ring.
TEST(RingTile, RingKeepsItsBarycentricCoordinatesInOtherPolygons) {
    const Setting setting = paper_setting();
    const Paper6Parameters parameters{1e-6, 1e-12, 1e-12, 1e-12, -0.2, 0.015};
    const auto regular = regular_tile(parameters, setting);
    auto polygon = geometry::regular_polygon(6, setting.tile_side);
    const auto stretch = [](double x, double y) {
        return geometry::Point2{1.3 * x + 0.2 * y + 5.0, 0.9 * y - 2.0};
    };
    for (auto& point : polygon) point = stretch(point.x, point.y);
    const auto stretched = ring_tile(parameters, paper_layout(), setting, polygon);
    for (std::size_t i = 0; i < 12; ++i) {
        const auto expected = stretch(regular.nodes[i].x(), regular.nodes[i].y());
        EXPECT_NEAR(stretched.nodes[i].x(), expected.x, 1e-12);
        EXPECT_NEAR(stretched.nodes[i].y(), expected.y, 1e-12);
    }
    EXPECT_EQ(ring_tile(parameters, paper_layout(), setting, geometry::regular_polygon(5, 0.02)).beams.size(),
              10U);
}

TEST(RingTile, AStraightCornerMayBendInwardsByRounding) {
    const geometry::Polygon square = {{0, 0}, {0.01, 1e-19}, {0.02, 0}, {0.02, 0.02}, {0, 0.02}};
    const mechanics::Frame frame = ring_tile(Paper6Parameters{1e-6, 1e-12, 1e-12, 1e-12, 0, 0.01},
                                             paper_layout(), paper_setting(), square);
    EXPECT_EQ(frame.beams.size(), 10U);
}

TEST(RingTile, RefusesAPolygonThatIsNotConvex) {
    const geometry::Polygon dart = {{0, 0}, {2, -1}, {1, 0}, {2, 1}};
    EXPECT_THROW((void)ring_tile(Paper6Parameters{1e-6, 1e-12, 1e-12, 1e-12, 0, 0.01}, paper_layout(),
                                 paper_setting(), dart),
                 base::GeometryError);
}

}  // namespace THIS_TEST
}  // namespace fretwork::reduction
