// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/honeycomb.hpp"

#include <fretwork/design/gamut.hpp>
#include <fretwork/design/reach/survey.hpp>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

namespace fretwork::design {
namespace THIS_TEST {

using Places = Eigen::Matrix<double, Eigen::Dynamic, 3>;

tiling::Tessellation plane() {
    return test::honeycomb(5, 5, {"0-1+1-6"}).tessellation;
}

Places bent(const tiling::Tessellation& tessellation,
            const std::function<Eigen::Vector3d(double, double)>& shape) {
    Places places(std::ssize(tessellation.interface_nodes), 3);
    for (const auto node : tessellation.interface_nodes.indices())
        places.row(node.value) =
            shape(tessellation.interface_nodes[node].x, tessellation.interface_nodes[node].y).transpose();
    return places;
}

void expect_everywhere(const Places& places, double largest, double smallest, double tolerance) {
    const auto found = tile_curvatures(plane(), places);
    for (const auto tile : found.indices()) {
        ASSERT_TRUE(found[tile]);
        EXPECT_NEAR(found[tile]->largest, largest, tolerance);
        EXPECT_NEAR(found[tile]->smallest, smallest, tolerance);
    }
}

TEST(TileCurvatures, AreZeroInThePlane) {
    expect_everywhere(bent(plane(), [](double x, double y) { return Eigen::Vector3d(x, y, 0.0); }), 0.0, 0.0,
                      1e-9);
}

/// A quadric through patches of five tiles is off a cylinder by the square of their size over its radius:
/// (0.07 m)^2 / (1 m)^2.
TEST(TileCurvatures, OfACylinderAreOneOverItsRadiusAndZero) {
    const auto cylinder = [](double x, double y) {
        return Eigen::Vector3d(std::sin(x), y, 1.0 - std::cos(x));
    };
    expect_everywhere(bent(plane(), cylinder), 1.0, 0.0, 0.01);
    const auto down = [](double x, double y) { return Eigen::Vector3d(x, std::sin(y), std::cos(y) - 1.0); };
    expect_everywhere(bent(plane(), down), 0.0, -1.0, 0.01);
}

TEST(TileCurvatures, OfASaddleHaveBothSigns) {
    const auto saddle = [](double x, double y) { return Eigen::Vector3d(x, y, 0.5 * 0.2 * (x * x - y * y)); };
    expect_everywhere(bent(plane(), saddle), 0.2, -0.2, 0.005);
}

TEST(TileCurvatures, AreTheSameWhereverTheSurfaceIsTurned) {
    const Eigen::Matrix3d turn =
        Eigen::AngleAxisd(2.0, Eigen::Vector3d(1.0, 2.0, -0.5).normalized()).toRotationMatrix();
    const auto cylinder = [&](double x, double y) -> Eigen::Vector3d {
        return turn * Eigen::Vector3d(std::sin(x), y, 1.0 - std::cos(x)) + Eigen::Vector3d(1.0, 2.0, 3.0);
    };
    expect_everywhere(bent(plane(), cylinder), 1.0, 0.0, 0.01);
}

TEST(TileCurvatures, AreNotKnownWhereANodeHasNoPlace) {
    Places places = bent(plane(), [](double x, double y) { return Eigen::Vector3d(x, y, 0.0); });
    places(0, 2) = std::numeric_limits<double>::quiet_NaN();
    const auto found = tile_curvatures(plane(), places);
    EXPECT_FALSE(found[tiling::TileIndex(0)]);
    EXPECT_TRUE(found[tiling::TileIndex(24)]);
}

/// Goals for z, then goals of rotations, whose wanted places are the present ones.
TEST(Gamut, AGoalLeavesWhatAnotherGoalOfItsNodeWants) {
    const tiling::Tessellation tessellation = plane();
    const Places wanted =
        bent(tessellation, [](double x, double y) { return Eigen::Vector3d(x, y, 0.5 * x * x); });
    const Places present = bent(tessellation, [](double x, double y) { return Eigen::Vector3d(x, y, 0.0); });
    CaseShape shape;
    shape.displacements.setZero(present.rows(), 6);
    for (const Places& places : {wanted, present}) {
        for (int node = 0; node < static_cast<int>(places.rows()); ++node)
            shape.goals.push_back({node, places.row(node).transpose(), 0.0});
    }
    Gamut gamut;
    detail::add_wanted_curvatures(tessellation, {shape}, gamut);
    EXPECT_EQ(gamut.wanted.size(), tessellation.tiles.size());
    for (const Curvatures& own : gamut.wanted) EXPECT_GT(own.largest, 0.5);
    for (const Curvatures& own : gamut.designed) EXPECT_NEAR(own.largest, 0.0, 1e-9);
}

TEST(Gamut, CountsWantedCurvaturesFarFromAllReachedOnes) {
    Gamut gamut;
    EXPECT_FALSE(gamut.share_outside());
    gamut.reached = {{1.0, 0.0}, {0.5, 0.0}};
    gamut.wanted = {{0.95, 0.0}, {0.55, 0.02}, {1.0, 1.0}, {0.8, 0.0}};
    EXPECT_DOUBLE_EQ(*gamut.share_outside(), 0.5);
}

}  // namespace THIS_TEST
}  // namespace fretwork::design
