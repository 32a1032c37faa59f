// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/exports/drawings/surface_drawing.hpp>

namespace fretwork::exports::detail {

/// Parallel projection onto the plane across the line of sight.
class Projection {
  public:
    explicit Projection(const ViewOptions& view);
    /// From above: x and y stay as they are.
    static Projection from_above();

    [[nodiscard]] geometry::Point2 operator()(const Eigen::Vector3d& point) const;
    /// A point of the plane z = 0.
    [[nodiscard]] geometry::Point2 operator()(const geometry::Point2& point) const;
    /// The distance of a point from the plane through the origin, towards the viewer, m.
    [[nodiscard]] double nearness(const Eigen::Vector3d& point) const;
    [[nodiscard]] std::vector<geometry::Point2> all(std::span<const geometry::Point2> points) const;
    [[nodiscard]] std::vector<geometry::Point2> all(std::span<const Eigen::Vector3d> points) const;

  private:
    Projection(const Eigen::Vector3d& right, const Eigen::Vector3d& up) : right_(right), up_(up) {}
    Eigen::Vector3d right_;
    Eigen::Vector3d up_;
};

}  // namespace fretwork::exports::detail
