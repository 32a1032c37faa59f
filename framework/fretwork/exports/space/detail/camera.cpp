// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/exports/space/detail/camera.hpp>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace fretwork::exports::detail {
namespace {

constexpr double kHalfHeight = 0.22;  // tangent of half of the field of view's height: a lens of 55 mm
constexpr double kFilled = 0.92;      // share of the picture

Eigen::Matrix3d axes_of(const ViewOptions& view) {
    const Eigen::Vector3d right(std::cos(view.azimuth), std::sin(view.azimuth), 0.0);
    const Eigen::Vector3d up(-std::sin(view.elevation) * std::sin(view.azimuth),
                             std::sin(view.elevation) * std::cos(view.azimuth), std::cos(view.elevation));
    Eigen::Matrix3d axes;
    axes << right, up, right.cross(up);
    return axes;
}

/// The area of a polygon as seen along an axis.
double seen_area(const std::vector<Eigen::Vector3d>& face, const Eigen::Vector3d& sight) {
    Eigen::Vector3d area = Eigen::Vector3d::Zero();
    for (std::size_t k = 0; k < face.size(); ++k) area += face[k].cross(face[(k + 1) % face.size()]);
    return 0.5 * std::abs(area.dot(sight));
}

/// A measure of how much of the tiles' area and of the displacements is seen.
double quality(std::span<const std::vector<Eigen::Vector3d>> faces, std::span<const Eigen::Vector3d> moves,
               const Eigen::Vector3d& sight) {
    double area = 0.0;
    for (const auto& face : faces) area += seen_area(face, sight);
    double seen = 0.0;
    double all = std::numeric_limits<double>::min();
    for (const Eigen::Vector3d& move : moves) {
        seen += (move - sight * sight.dot(move)).norm();
        all += move.norm();
    }
    return std::sqrt(area) * (0.2 + seen / all);
}

}  // namespace

Camera::Camera(const ViewOptions& view, double aspect, std::span<const Eigen::Vector3d> points)
    : axes_(axes_of(view)), eye_(Eigen::Vector3d::Zero()), aspect_(aspect) {
    fit(points);
}

Eigen::Vector3d Camera::project(const Eigen::Vector3d& point) const {
    const Eigen::Vector3d own = axes_.transpose() * (point - eye_);
    return {own.x() / (-own.z() * kHalfHeight * aspect_), own.y() / (-own.z() * kHalfHeight), -own.z()};
}

Eigen::Vector3d Camera::ray(double x, double y) const {
    return axes_ * Eigen::Vector3d(x * kHalfHeight * aspect_, y * kHalfHeight, -1.0);
}

/// Place the eye so that the points fill their share of the picture. In perspective, where points are seen
/// depends on the distance of the eye, so the place is found by iteration.
void Camera::fit(std::span<const Eigen::Vector3d> points) {
    Eigen::AlignedBox3d box;
    for (const Eigen::Vector3d& point : points) box.extend(Eigen::Vector3d(axes_.transpose() * point));
    const double size = std::max(box.diagonal().norm(), 1e-6);
    Eigen::Vector3d own = box.center();
    own.z() = box.max().z() + size / kHalfHeight;
    constexpr int kRounds = 12;
    for (int round = 0; round < kRounds; ++round) {
        eye_ = axes_ * own;
        Eigen::AlignedBox2d seen;
        for (const Eigen::Vector3d& point : points) seen.extend(Eigen::Vector2d(project(point).head<2>()));
        const double distance = own.z() - box.center().z();
        own.x() += seen.center().x() * distance * kHalfHeight * aspect_;
        own.y() += seen.center().y() * distance * kHalfHeight;
        const double filled = 0.5 * seen.sizes().maxCoeff() / kFilled;
        own.z() = box.max().z() + std::max((own.z() - box.max().z()) * filled, 1e-3 * size);
    }
    eye_ = axes_ * own;
}

ViewOptions best_view(std::span<const std::vector<Eigen::Vector3d>> faces,
                      std::span<const Eigen::Vector3d> moves) {
    constexpr int kAzimuths = 24;
    constexpr double kDegree = std::numbers::pi / 180.0;
    ViewOptions best;
    double best_quality = -1.0;
    for (int a = 0; a < kAzimuths; ++a) {
        // Off the axes, because rows of tiles would hide each other along the axes.
        const double azimuth = (a + 0.5) * 2.0 * std::numbers::pi / kAzimuths - std::numbers::pi;
        for (const double elevation : {18.0 * kDegree, 25.0 * kDegree, 32.0 * kDegree}) {
            const ViewOptions view{azimuth, elevation};
            const double found = quality(faces, moves, axes_of(view).col(2));
            if (found <= best_quality * (1.0 + 1e-9)) continue;
            best_quality = found;
            best = view;
        }
    }
    return best;
}

ViewOptions start_view(const BarScene& bars, const Scene& scene) {
    if (scene.view) return *scene.view;
    std::vector<std::vector<Eigen::Vector3d>> faces;
    std::vector<Eigen::Vector3d> moves;
    for (const tiling::Tile& tile : scene.surface.tessellation.tiles) {
        std::vector<Eigen::Vector3d>& face = faces.emplace_back();
        for (const tiling::InterfaceIndex node : tile.interface_nodes) {
            face.push_back(place_of(bars, node.value, scene.displacement_scale));
            moves.emplace_back(bars.motion.row(node.value).head<3>());
        }
    }
    return best_view(faces, moves);
}

}  // namespace fretwork::exports::detail
