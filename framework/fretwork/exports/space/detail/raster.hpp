// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/exports/space/detail/bar_mesh.hpp>
#include <fretwork/exports/space/detail/camera.hpp>

#include <Eigen/Core>

#include <span>
#include <vector>

namespace fretwork::exports::detail {

/// A point of the mesh that is seen.
struct Sample {
    Eigen::Vector3f place, normal, colour;
    std::uint32_t pixel = 0;  ///< row by row from the upper left
};

/// The visible part of a mesh: up to `per_side` x `per_side` samples of each pixel, each on the nearest
/// surface. Normals look towards the eye.
std::vector<Sample> visible_samples(const Mesh& mesh, const Camera& camera, PixelSize size, int per_side);

/// The shadow map of a mesh for light from one direction: the part of the mesh nearest to the light.
class DepthMap {
  public:
    /// @param to_light  of length one
    DepthMap(const Mesh& mesh, const Eigen::Vector3f& to_light, int texels);
    /// True if light reaches a place. Pre: the place is at least texel_size() outside the mesh.
    [[nodiscard]] bool is_lit(const Eigen::Vector3f& place) const;
    [[nodiscard]] float texel_size() const { return 1.0F / texels_per_metre_; }

  private:
    Eigen::Vector3f across_, up_, to_light_;
    float x0_ = 0.0F, y0_ = 0.0F, texels_per_metre_ = 1.0F;
    PixelSize texels_;
    std::vector<float> depth_;  ///< the largest along to_light
    PixelSize blocks_;
    std::vector<float> block_depth_;  ///< largest depth in each block; enough for most lit places
};

}  // namespace fretwork::exports::detail
