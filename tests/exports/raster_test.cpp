// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/exports/space/detail/raster.hpp>

#include <gtest/gtest.h>

#include <numbers>

namespace fretwork::exports::detail {
namespace THIS_TEST {

using Eigen::Vector3d;
using Eigen::Vector3f;

constexpr PixelSize kSize{24, 15};

/// A camera above a square of a metre.
Camera camera_above() {
    const std::vector<Vector3d> corners = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    return {ViewOptions{0.0, std::numbers::pi / 2}, static_cast<double>(kSize.width) / kSize.height, corners};
}

/// A triangle in the plane around that square, with a corner on its left below, right and above.
Mesh triangle(float reach) {
    Mesh mesh;
    for (const Vector3f& place : {Vector3f(-reach, -reach, 0.0F), Vector3f(3.0F * reach, -reach, 0.0F),
                                  Vector3f(-reach, 3.0F * reach, 0.0F)})
        mesh.vertices.push_back({place, Vector3f::UnitZ(), Vector3f(0.5F, 0.25F, 1.0F)});
    mesh.triangles = {{0, 1, 2}};
    return mesh;
}

std::vector<int> samples_of_pixels(const Mesh& mesh, int per_side) {
    std::vector<int> counts(kSize.count(), 0);
    for (const Sample& sample : visible_samples(mesh, camera_above(), kSize, per_side))
        ++counts.at(sample.pixel);
    return counts;
}

/// Large pictures have fewer samples.
TEST(Raster, EveryPixelHasItsSamples) {
    for (const int per_side : {1, 2, 3})
        EXPECT_EQ(samples_of_pixels(triangle(100.0F), per_side),
                  std::vector<int>(kSize.count(), per_side * per_side))
            << per_side;
}

/// With sanitizers, the conversion to whole numbers is checked.
TEST(Raster, ACornerMayLieFurtherAwayThanWholeNumbersReach) {
    EXPECT_EQ(samples_of_pixels(triangle(1e12F), 2), std::vector<int>(kSize.count(), 4));
    for (const float away : {-1e12F, 1e12F}) {
        Mesh mesh = triangle(1.0F);
        for (Mesh::Vertex& vertex : mesh.vertices) vertex.place += Vector3f(away, away, 0.0F);
        mesh.vertices[1].place.x() *= 2.0F;
        mesh.vertices[2].place.y() *= 2.0F;
        EXPECT_EQ(samples_of_pixels(mesh, 2), std::vector<int>(kSize.count(), 0)) << away;
    }
}

}  // namespace THIS_TEST
}  // namespace fretwork::exports::detail
