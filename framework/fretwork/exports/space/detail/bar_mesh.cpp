// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/exports/space/detail/bar_mesh.hpp>
#include <fretwork/geometry/rotation.hpp>
#include <fretwork/mechanics/node_states.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fretwork::exports::detail {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Eigen::Vector3f;

constexpr double kPi = std::numbers::pi;

Matrix3d turn_at(const BarScene& scene, std::size_t node, double scale) {
    return geometry::exponential(scale * scene.motion.row(node).tail<3>().transpose()).matrix();
}

/// Both ends of a bar: places, tangents as long as the chord, and turns.
struct BentBar {
    Vector3d p0, p1, m0, m1;
    Matrix3d turn0, turn1;
};

BentBar bent_bar(const BarScene& scene, std::size_t bar, double scale) {
    const auto [from, to] = scene.bars[bar];
    const Vector3d along = (scene.nodes[to] - scene.nodes[from]).normalized();
    const Matrix3d turn0 = turn_at(scene, from, scale);
    const Matrix3d turn1 = turn_at(scene, to, scale);
    const Vector3d p0 = place_of(scene, from, scale);
    const Vector3d p1 = place_of(scene, to, scale);
    const double length = (p1 - p0).norm();
    return {p0, p1, length * turn0 * along, length * turn1 * along, turn0, turn1};
}

/// One piece for every five degrees of the largest turn, from end to end or from end to chord.
int pieces_of(const BentBar& bar) {
    const double length = (bar.p1 - bar.p0).norm();
    if (length == 0.0) return 0;
    const Vector3d chord = (bar.p1 - bar.p0) / length;
    const double bend = std::max({(bar.m0 / length - chord).norm(), (bar.m1 / length - chord).norm(),
                                  (bar.turn0.col(2) - bar.turn1.col(2)).norm()});
    return std::clamp(static_cast<int>(std::ceil(bend * 180.0 / kPi / 5.0)), 1, 12);
}

class Builder {
  public:
    Builder(const BarScene& scene, double scale, const EndColours& colours, std::span<const int> pieces)
        : scene_(scene),
          scale_(scale),
          colours_(colours),
          pieces_(pieces),
          joint_colours_(scene.nodes.size(), Vector3f::Zero()),
          joint_uses_(scene.nodes.size(), 0) {}

    Mesh build() && {
        for (std::size_t b = 0; b < scene_.bars.size(); ++b) add_bar(b);
        for (std::size_t n = 0; n < scene_.nodes.size(); ++n) {
            if (joint_uses_[n] > 0) add_joint(n);
        }
        return std::move(mesh_);
    }

  private:
    /// A cross section of a bar.
    struct Cut {
        Vector3d center, axis2, axis3;
        Vector3f colour;
    };

    [[nodiscard]] Matrix3d turn_of(std::size_t node) const { return turn_at(scene_, node, scale_); }
    [[nodiscard]] Vector3d place(std::size_t node) const {
        return place_of(scene_, static_cast<int>(node), scale_);
    }

    void add_bar(std::size_t bar) {
        const int pieces = pieces_[bar];
        if (pieces == 0) return;
        const std::size_t from = scene_.bars[bar][0];
        const std::size_t to = scene_.bars[bar][1];
        const auto& [p0, p1, m0, m1, turn0, turn1] = bent_bar(scene_, bar, scale_);
        std::vector<Cut> cuts;
        for (int i = 0; i <= pieces; ++i) {
            const double s = static_cast<double>(i) / pieces;
            const double s2 = s * s;
            const double s3 = s2 * s;
            const Vector3d tangent =
                (6 * s2 - 6 * s) * (p0 - p1) + (3 * s2 - 4 * s + 1) * m0 + (3 * s2 - 2 * s) * m1;
            const Vector3d normal = ((1 - s) * turn0.col(2) + s * turn1.col(2));
            Cut cut;
            cut.center =
                (2 * s3 - 3 * s2 + 1) * p0 + (3 * s2 - 2 * s3) * p1 + (s3 - 2 * s2 + s) * m0 + (s3 - s2) * m1;
            cut.axis2 = normal.cross(tangent).normalized();
            cut.axis3 = tangent.cross(cut.axis2).normalized();
            const auto share = static_cast<float>(s);
            cut.colour = (1 - share) * colours_[2 * bar] + share * colours_[2 * bar + 1];
            cuts.push_back(cut);
        }
        add_sides(cuts);
        for (const auto& [node, end] : {std::pair{from, 2 * bar}, std::pair{to, 2 * bar + 1}}) {
            joint_colours_[node] += colours_[end];
            ++joint_uses_[node];
        }
    }

    void add_sides(const std::vector<Cut>& cuts) {
        const double w = 0.5 * scene_.width;
        const double h = 0.5 * scene_.height;
        for (int side = 0; side < 4; ++side) {
            const auto first = static_cast<std::uint32_t>(mesh_.vertices.size());
            for (const Cut& cut : cuts) {
                const std::array<Vector3d, 4> normals = {cut.axis2, cut.axis3, -cut.axis2, -cut.axis3};
                const Vector3d& normal = normals[side];
                const Vector3d& next = normals[(side + 1) % 4];
                const double reach = side % 2 == 0 ? w : h;
                const double half = side % 2 == 0 ? h : w;
                for (const double sign : {-1.0, 1.0})
                    add_vertex(cut.center + reach * normal + sign * half * next, normal, cut.colour);
            }
            for (std::uint32_t i = 0; i + 1 < cuts.size(); ++i) add_quad(first + 2 * i);
        }
    }

    /// A round plate that fills the wedges between the bars of a node.
    void add_joint(std::size_t node) {
        constexpr std::uint32_t kCorners = 10;
        const Vector3d center = place(node);
        const Matrix3d turn = turn_of(node);
        const Vector3f colour = joint_colours_[node] / static_cast<float>(joint_uses_[node]);
        const Vector3d up = 0.5 * scene_.height * turn.col(2);
        const auto rim = [&](std::uint32_t corner) -> Vector3d {
            const double angle = 2.0 * kPi * corner / kCorners;
            return std::cos(angle) * turn.col(0) + std::sin(angle) * turn.col(1);
        };
        const auto side = static_cast<std::uint32_t>(mesh_.vertices.size());
        for (std::uint32_t c = 0; c <= kCorners; ++c) {
            for (const double sign : {-1.0, 1.0})
                add_vertex(center + 0.5 * scene_.width * rim(c) + sign * up, rim(c), colour);
        }
        for (std::uint32_t c = 0; c < kCorners; ++c) add_quad(side + 2 * c);
        for (const double sign : {-1.0, 1.0}) {
            const auto first = static_cast<std::uint32_t>(mesh_.vertices.size());
            for (std::uint32_t c = 0; c < kCorners; ++c)
                add_vertex(center + 0.5 * scene_.width * rim(c) + sign * up, sign * turn.col(2), colour);
            for (std::uint32_t c = 1; c + 1 < kCorners; ++c)
                mesh_.triangles.push_back({first, first + c, first + c + 1});
        }
    }

    void add_vertex(const Vector3d& place, const Vector3d& normal, const Vector3f& colour) {
        mesh_.vertices.push_back({place.cast<float>(), normal.cast<float>(), colour});
    }
    /// Add a quad between two successive pairs of vertices.
    void add_quad(std::uint32_t first) {
        mesh_.triangles.push_back({first, first + 1, first + 2});
        mesh_.triangles.push_back({first + 1, first + 3, first + 2});
    }

    const BarScene& scene_;
    double scale_;
    const EndColours& colours_;
    std::span<const int> pieces_;
    std::vector<Vector3f> joint_colours_;  ///< sums
    std::vector<int> joint_uses_;
    Mesh mesh_;
};

}  // namespace

std::vector<int> bar_pieces(const BarScene& scene, double scale) {
    std::vector<int> pieces;
    for (std::size_t b = 0; b < scene.bars.size(); ++b)
        pieces.push_back(pieces_of(bent_bar(scene, b, scale)));
    return pieces;
}

Mesh bar_mesh(const BarScene& scene, double scale, const EndColours& colours) {
    return bar_mesh(scene, scale, colours, bar_pieces(scene, scale));
}

Mesh bar_mesh(const BarScene& scene, double scale, const EndColours& colours, std::span<const int> pieces) {
    return Builder(scene, scale, colours, pieces).build();
}

void add_ball(Mesh& mesh, const Vector3d& center, double radius, const Vector3f& colour) {
    constexpr std::uint32_t kRings = 12;
    constexpr std::uint32_t kCorners = 20;
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    for (std::uint32_t ring = 0; ring <= kRings; ++ring) {
        const double polar = kPi * ring / kRings;
        for (std::uint32_t c = 0; c <= kCorners; ++c) {
            const double angle = 2.0 * kPi * c / kCorners;
            const Vector3d normal(std::sin(polar) * std::cos(angle), std::sin(polar) * std::sin(angle),
                                  std::cos(polar));
            mesh.vertices.push_back({(center + radius * normal).cast<float>(), normal.cast<float>(), colour});
        }
    }
    for (std::uint32_t ring = 0; ring < kRings; ++ring) {
        for (std::uint32_t c = 0; c < kCorners; ++c) {
            const std::uint32_t at = first + ring * (kCorners + 1) + c;
            mesh.triangles.push_back({at, at + 1, at + kCorners + 1});
            mesh.triangles.push_back({at + 1, at + kCorners + 2, at + kCorners + 1});
        }
    }
}

}  // namespace fretwork::exports::detail
