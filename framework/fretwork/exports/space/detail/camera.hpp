// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/exports/drawings/surface_drawing.hpp>
#include <fretwork/exports/space/bar_scene.hpp>

#include <Eigen/Core>

#include <span>
#include <vector>

namespace fretwork::exports::detail {

/// A perspective camera. Its own axes are x to the right, y up, and z towards the viewer.
class Camera {
  public:
    /// Moves the camera so that all points are in the picture, with some margin.
    Camera(const ViewOptions& view, double aspect, std::span<const Eigen::Vector3d> points);

    /// x and y from -1 to 1 in the picture, z the distance in front of the eye, metres.
    [[nodiscard]] Eigen::Vector3d project(const Eigen::Vector3d& point) const;
    [[nodiscard]] const Eigen::Vector3d& eye() const { return eye_; }
    /// The direction, from the eye, of a place in the picture. Not of length one.
    [[nodiscard]] Eigen::Vector3d ray(double x, double y) const;
    /// A direction that is given in the camera's axes.
    [[nodiscard]] Eigen::Vector3d from_own(const Eigen::Vector3d& direction) const {
        return axes_ * direction;
    }

  private:
    void fit(std::span<const Eigen::Vector3d> points);

    Eigen::Matrix3d axes_;  ///< as columns
    Eigen::Vector3d eye_;
    double aspect_;
};

/// The direction, of 72 tried, from which tiles and displacements are seen best.
///
/// @param faces  of the tiles: closed polygons of deformed places
/// @param moves  displacements of points all over the surface
ViewOptions best_view(std::span<const std::vector<Eigen::Vector3d>> faces,
                      std::span<const Eigen::Vector3d> moves);

/// The first direction of the viewer of a scene: Scene::view, or else the best_view().
ViewOptions start_view(const BarScene& bars, const Scene& scene);

}  // namespace fretwork::exports::detail
