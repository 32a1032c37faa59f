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

/// The visible part of a mesh: `per_side` x `per_side` samples of each pixel, the nearest surface first.
/// Normals look towards the eye.
std::vector<Sample> visible_samples(const Mesh& mesh, const Camera& camera, PixelSize size, int per_side);

/// How far the mesh reaches against light that comes from one direction: shadows are thrown by it.
class DepthMap {
  public:
    /// @param to_light  of length one
    DepthMap(const Mesh& mesh, const Eigen::Vector3f& to_light, int texels);
    /// Whether light reaches a place that is outside of the mesh by at least texel_size().
    [[nodiscard]] bool is_lit(const Eigen::Vector3f& place) const;
    [[nodiscard]] float texel_size() const { return 1.0F / texels_per_metre_; }

  private:
    Eigen::Vector3f across_, up_, to_light_;
    float x0_ = 0.0F, y0_ = 0.0F, texels_per_metre_ = 1.0F;
    PixelSize texels_;
    std::vector<float> depth_;  ///< the largest along to_light
    PixelSize blocks_;
    std::vector<float> block_depth_;  ///< of blocks of texels: most places are lit by them alone
};

}  // namespace fretwork::exports::detail
