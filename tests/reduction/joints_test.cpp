// SPDX-License-Identifier: GPL-3.0-or-later
#include "fixtures.hpp"

#include <fretwork/mechanics/condensation.hpp>
#include <fretwork/mechanics/solve.hpp>
#include <fretwork/reduction/effective_properties.hpp>
#include <fretwork/reduction/models/condensed_tile.hpp>
#include <fretwork/reduction/scenarios/joints.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace fretwork::reduction {
namespace THIS_TEST {

constexpr double kDegree = std::numbers::pi / 180.0;

Setting stiff_setting() {
    Setting setting = paper_setting();
    setting.joints = Joints::Stiff;
    return setting;
}

/// Bars from a node in the origin in these directions (degrees), each as long as 1 m.
std::vector<double> reaches_of_star(const std::vector<double>& directions) {
    pattern::Fan fan{.sides = 3};
    fan.nodes.resize(directions.size() + 1);
    std::vector<geometry::Point2> places{{0.0, 0.0}};
    for (std::size_t i = 0; i < directions.size(); ++i) {
        const double angle = directions[i] * kDegree;
        places.push_back({std::cos(angle), std::sin(angle)});
        fan.edges.push_back({pattern::FanNodeIndex(0), pattern::FanNodeIndex(i + 1)});
    }
    return joint_reaches(fan, places);
}

// Half a width over the tangent of half the angle: where the edges of two bars meet (elementary geometry).
TEST(JointReach, EndsWhereTheOutlinesOfNeighboursPart) {
    constexpr double kRounding = 1e-12;
    for (const double reach : reaches_of_star({0, 90, 180, 270})) EXPECT_NEAR(reach, 0.5, kRounding);
    for (const double reach : reaches_of_star({10, 70, 130, 190, 250, 310}))
        EXPECT_NEAR(reach, std::sqrt(3.0) / 2.0, kRounding);
    for (const double reach : reaches_of_star({0, 180})) EXPECT_NEAR(reach, 0.0, kRounding);
    for (const double reach : reaches_of_star({-100, 20}))
        EXPECT_NEAR(reach, 0.5 / std::sqrt(3.0), kRounding)
            << "240 degrees on the other side count for nothing";
    EXPECT_EQ(reaches_of_star({50}).front(), 0.0);
}

TEST(JointReach, OfTwoNeighboursTheOneThatPartsLaterCounts) {
    const auto reaches = reaches_of_star({0, 30, 150});
    EXPECT_NEAR(reaches[0], 0.5 / std::tan(15 * kDegree), 1e-12);
    EXPECT_NEAR(reaches[1], 0.5 / std::tan(15 * kDegree), 1e-12);
    EXPECT_NEAR(reaches[2], 0.5 / std::tan(60 * kDegree), 1e-12);
}

/// The reach along a fan's bars of one pattern in the regular hexagon.
std::vector<double> reaches_of(std::string_view id) {
    const pattern::Fan fan = pattern::make_fan(paper_layout(), paper_pattern(id), 6);
    return joint_reaches(fan, pattern::place_fan(paper_layout(), fan, geometry::regular_polygon(6, 0.026)));
}

TEST(JointReach, BeyondASideTheTileCountsAsItsOwnNeighbour) {
    // "0-6": a bar from the centre meets its like beyond the side, straight on; six of them meet in the
    // centre.
    for (const double reach : reaches_of("0-6")) EXPECT_NEAR(reach, std::sqrt(3.0) / 2.0, 1e-9);
}

TEST(StiffJoints, LeaveCentrelinesAsTheyAre) {
    const Setting setting = paper_setting();
    const TileMaterial bar = bar_of(setting, {.length = 0.01, .joint_reach = 3.0});
    EXPECT_EQ(bar.section, setting.section);
    EXPECT_EQ(bar.material, setting.material);
}

/// A bar with ends that are rigid in a plane, as three beams: the rigid ones a million times as stiff, and as
/// soft out of the plane as the bar.
mechanics::Frame bar_with_rigid_ends(const Setting& setting, double length, double rigid_end) {
    TileMaterial rigid{setting.section, setting.material};
    rigid.section.area *= 1e6;
    rigid.section.I3 *= 1e6;
    rigid.section.J *= 1e6;
    mechanics::Frame frame;
    frame.nodes = {{0, 0, 0}, {rigid_end, 0, 0}, {length - rigid_end, 0, 0}, {length, 0, 0}};
    for (int i = 0; i < 3; ++i) {
        frame.beams.push_back({.nodes = {mechanics::NodeIndex(i), mechanics::NodeIndex(i + 1)},
                               .section = i == 1 ? setting.section : rigid.section,
                               .material = setting.material});
    }
    return frame;
}

/// How far the far end moves under unit loads if it may move, or twist, but not turn.
Eigen::Vector4d moves_of_guided_end(mechanics::Frame frame) {
    const auto end = mechanics::NodeIndex(frame.nodes.size() - 1);
    frame.supports = {{mechanics::NodeIndex(0), mechanics::DofSet::all()},
                      {end, {{false, false, false, false, true, true}}}};
    frame.loads = {{end, {1e-3, 1e-3, 1e-3}, {1e-6, 0, 0}}};
    const auto moved =
        mechanics::solve({frame, {}}, {.solver = mechanics::Solver::Linear}).solution.displacements;
    return moved.row(end.value).head<4>().transpose();
}

TEST(StiffJoints, GiveABarTheStiffnessOfOneWithRigidEnds) {
    const Setting setting = stiff_setting();
    constexpr double kLength = 0.012;
    constexpr double kReach = 1.5;  // of both ends together, in widths
    const TileMaterial bar = bar_of(setting, {.length = kLength, .joint_reach = kReach});
    mechanics::Frame one;
    one.nodes = {{0, 0, 0}, {kLength, 0, 0}};
    one.beams.push_back({.nodes = {mechanics::NodeIndex(0), mechanics::NodeIndex(1)},
                         .section = bar.section,
                         .material = bar.material});
    const double rigid_end = kStiffShare * kReach * 0.002 / 2.0;
    const Eigen::Vector4d found = moves_of_guided_end(one);
    const Eigen::Vector4d wanted = moves_of_guided_end(bar_with_rigid_ends(setting, kLength, rigid_end));
    // Stretched, moved sideways in the plane and out of it, twisted. The rigid ends give by a millionth.
    for (Eigen::Index i = 0; i < 4; ++i) EXPECT_NEAR(found[i], wanted[i], 1e-5 * std::abs(wanted[i])) << i;
}

TEST(StiffJoints, KeepMassAndBendingOutOfThePlane) {
    const Setting setting = stiff_setting();
    const TileMaterial bar = bar_of(setting, {.length = 0.012, .joint_reach = 2.0});
    EXPECT_DOUBLE_EQ(bar.section.area * bar.material.density,
                     setting.section.area * setting.material.density);
    EXPECT_EQ(bar.section.I2, setting.section.I2);
}

TEST(StiffJoints, LeaveALeastShareOfShortBarsElastic) {
    const Setting setting = stiff_setting();
    const TileMaterial bar = bar_of(setting, {.length = 0.003, .joint_reach = 20.0});
    EXPECT_DOUBLE_EQ(bar.section.area, setting.section.area / kLeastElasticShare);
}

TEST(StiffJoints, LetATileMoveAsARigidBody) {
    const mechanics::Frame frame =
        pattern_frame(paper_layout(), paper_pattern("0-1+1-6+1-5+5-6"), stiff_setting());
    const Eigen::MatrixXd stiffness = condensed_frame(frame, 6);
    Eigen::MatrixXd motions = Eigen::MatrixXd::Zero(36, 6);
    for (Eigen::Index i = 0; i < 6; ++i) {
        const Eigen::Vector3d& place = frame.nodes[i];
        motions.block<6, 6>(6 * i, 0).setIdentity();
        for (Eigen::Index axis = 0; axis < 3; ++axis)
            motions.block<3, 1>(6 * i, 3 + axis) = Eigen::Vector3d::Unit(axis).cross(place);
    }
    EXPECT_LT((stiffness * motions).cwiseAbs().maxCoeff(), 1e-9 * stiffness.cwiseAbs().maxCoeff());
    EXPECT_LT((stiffness - stiffness.transpose()).cwiseAbs().maxCoeff(),
              1e-9 * stiffness.cwiseAbs().maxCoeff());
}

TEST(StiffJoints, KeepHexagonsIsotropic) {
    const auto found = effective_properties(paper_layout(), paper_pattern("0-1+1-3+3-6"), stiff_setting());
    for (const Eigen::Matrix3d& tensor : {found.A, found.D}) {
        const double stiffness = directional_stiffness(tensor, 0.0);
        for (const double angle : {0.3, 0.9, 1.7, 2.6})
            EXPECT_NEAR(directional_stiffness(tensor, angle), stiffness, 1e-7 * stiffness);
    }
}

TEST(StiffJoints, AreInTheResponses) {
    Setting setting = paper_setting();
    setting.magnitudes = 1;
    setting.scenarios = {paper_scenarios()[0], paper_scenarios()[2]};
    for (Scenario& scenario : setting.scenarios) scenario.max_magnitude *= 1e-4;
    const auto soft = compute_responses(paper_layout(), paper_pattern("0-1+1-6"), setting);
    setting.joints = Joints::Stiff;
    const auto stiff = compute_responses(paper_layout(), paper_pattern("0-1+1-6"), setting);
    for (std::size_t i = 0; i < soft.size(); ++i) {
        EXPECT_LT(stiff[i].samples[0].displacements.leftCols<3>().norm(),
                  soft[i].samples[0].displacements.leftCols<3>().norm())
            << soft[i].scenario;
    }
}

}  // namespace THIS_TEST
}  // namespace fretwork::reduction
