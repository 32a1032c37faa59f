// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/exports/drawings/detail/projection.hpp>

#include <cmath>

namespace fretwork::exports::detail {

using geometry::Point2;

Projection::Projection(const ViewOptions& view)
    : right_(std::cos(view.azimuth), std::sin(view.azimuth), 0.0),
      up_(-std::sin(view.elevation) * std::sin(view.azimuth),
          std::sin(view.elevation) * std::cos(view.azimuth), std::cos(view.elevation)) {}

Projection Projection::from_above() {
    return {Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitY()};
}

Point2 Projection::operator()(const Eigen::Vector3d& point) const {
    return {right_.dot(point), up_.dot(point)};
}
Point2 Projection::operator()(const Point2& point) const {
    return (*this)(Eigen::Vector3d(point.x, point.y, 0.0));
}

double Projection::nearness(const Eigen::Vector3d& point) const {
    return right_.cross(up_).dot(point);
}

std::vector<Point2> Projection::all(std::span<const Point2> points) const {
    std::vector<Point2> places;
    for (const Point2& point : points) places.push_back((*this)(point));
    return places;
}
std::vector<Point2> Projection::all(std::span<const Eigen::Vector3d> points) const {
    std::vector<Point2> places;
    for (const Eigen::Vector3d& point : points) places.push_back((*this)(point));
    return places;
}

}  // namespace fretwork::exports::detail
