// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <filesystem>
#include <memory>

namespace fretwork::design::detail {

/// A surface of triangles in space that finds its point nearest to a given point.
class SpaceMesh {
  public:
    /// Read the surface from a mesh file. Throws as outlines::read_space_mesh(), and InputError if all faces
    /// have no area.
    explicit SpaceMesh(const std::filesystem::path& path);
    ~SpaceMesh();
    SpaceMesh(const SpaceMesh&) = delete;
    SpaceMesh& operator=(const SpaceMesh&) = delete;

    struct Nearest {
        Eigen::Vector3d point;
        Eigen::Vector3d normal;  ///< normal of the triangle at the point, of unit length
    };
    [[nodiscard]] Nearest nearest(const Eigen::Vector3d& point) const;

  private:
    class Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace fretwork::design::detail
