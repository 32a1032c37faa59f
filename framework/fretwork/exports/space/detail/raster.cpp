// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/exports/space/detail/raster.hpp>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>

namespace fretwork::exports::detail {
namespace {

using Eigen::Vector2f;
using Eigen::Vector3f;

constexpr int kBlock = 16;  ///< texels, along a side

/// The range of columns in which a triangle crosses a row of the grid. It saves time, because thin triangles
/// across the picture fill little of their boxes.
std::array<float, 2> crossing(const std::array<Vector2f, 3>& corners, float y) {
    std::array<float, 2> range = {std::numeric_limits<float>::max(), std::numeric_limits<float>::lowest()};
    for (std::size_t k = 0; k < 3; ++k) {
        const Vector2f& p = corners[k];
        const Vector2f& q = corners[(k + 1) % 3];
        if (y < std::min(p.y(), q.y()) || y > std::max(p.y(), q.y())) continue;
        const float share = p.y() == q.y() ? 0.0F : (y - p.y()) / (q.y() - p.y());
        const float x = p.x() + share * (q.x() - p.x());
        range = {std::min(range[0], x), std::max(range[1], x)};
    }
    return range;
}

/// Calls body(x, y, weights) for every grid point inside of a triangle; the weights are those of its corners.
template <class Body>
void for_each_point(const std::array<Vector2f, 3>& corners, PixelSize size, const Body& body) {
    const auto& [a, b, c] = corners;
    const float area = (b - a).x() * (c - a).y() - (b - a).y() * (c - a).x();
    if (!(std::abs(area) > 1e-12F)) return;
    // A corner may lie further away than whole numbers reach.
    const auto first = [](float p, float q, float r, int count) {
        return static_cast<int>(std::clamp(std::ceil(std::min({p, q, r})), 0.0F, static_cast<float>(count)));
    };
    const auto last = [](float p, float q, float r, int count) {
        return static_cast<int>(
            std::clamp(std::floor(std::max({p, q, r})), -1.0F, static_cast<float>(count - 1)));
    };
    const int x0 = first(a.x(), b.x(), c.x(), size.width);
    const int x1 = last(a.x(), b.x(), c.x(), size.width);
    const int y1 = last(a.y(), b.y(), c.y(), size.height);
    for (int y = first(a.y(), b.y(), c.y(), size.height); y <= y1; ++y) {
        const auto [from, to] = crossing(corners, static_cast<float>(y));
        // A column more on each side, for rounding: what is inside is decided below.
        const auto start = static_cast<int>(
            std::clamp(std::floor(from) - 1.0F, static_cast<float>(x0), static_cast<float>(x1 + 1)));
        const auto end = static_cast<int>(
            std::clamp(std::ceil(to) + 1.0F, static_cast<float>(x0 - 1), static_cast<float>(x1)));
        for (int x = start; x <= end; ++x) {
            const Vector2f p(static_cast<float>(x), static_cast<float>(y));
            const float wb = ((p - a).x() * (c - a).y() - (p - a).y() * (c - a).x()) / area;
            const float wc = ((b - a).x() * (p - a).y() - (b - a).y() * (p - a).x()) / area;
            const float wa = 1.0F - wb - wc;
            if (wa < 0.0F || wb < 0.0F || wc < 0.0F) continue;
            body(x, y, Vector3f(wa, wb, wc));
        }
    }
}

/// The nearest triangle at each grid point.
struct Hit {
    float nearness = 0.0F;  ///< one over the distance, which is linear in the picture; 0: nothing is there
    std::uint32_t triangle = 0;
    Vector3f weights;  ///< of the corners in space
};

class PictureRaster {
  public:
    PictureRaster(const Mesh& mesh, const Camera& camera, PixelSize grid)
        : mesh_(mesh), grid_(grid), hits_(grid.count()) {
        for (const Mesh::Vertex& vertex : mesh.vertices) {
            const Eigen::Vector3d seen = camera.project(vertex.place.cast<double>());
            places_.emplace_back(static_cast<float>(0.5 * (seen.x() + 1.0) * grid.width - 0.5),
                                 static_cast<float>(0.5 * (1.0 - seen.y()) * grid.height - 0.5),
                                 static_cast<float>(1.0 / seen.z()));
        }
        for (std::size_t t = 0; t < mesh.triangles.size(); ++t) draw(static_cast<std::uint32_t>(t));
    }
    [[nodiscard]] const std::vector<Hit>& hits() const { return hits_; }

  private:
    void draw(std::uint32_t triangle) {
        const auto& ends = mesh_.triangles[triangle];
        const std::array<Vector3f, 3> p = {places_[ends[0]], places_[ends[1]], places_[ends[2]]};
        const Vector3f nearness(p[0].z(), p[1].z(), p[2].z());
        for_each_point({p[0].head<2>(), p[1].head<2>(), p[2].head<2>()}, grid_,
                       [&](int x, int y, const Vector3f& weights) {
                           const float near = weights.dot(nearness);
                           Hit& hit = hits_[grid_.at(x, y)];
                           if (near > hit.nearness)
                               hit = {near, triangle, weights.cwiseProduct(nearness) / near};
                       });
    }

    const Mesh& mesh_;
    PixelSize grid_;
    std::vector<Hit> hits_;
    std::vector<Vector3f> places_;  ///< grid x and y, nearness
};

}  // namespace

std::vector<Sample> visible_samples(const Mesh& mesh, const Camera& camera, PixelSize size, int per_side) {
    const PixelSize grid{size.width * per_side, size.height * per_side};
    const PictureRaster raster(mesh, camera, grid);
    const Vector3f eye = camera.eye().cast<float>();
    std::vector<Sample> samples;
    samples.reserve(static_cast<std::size_t>(
        std::ranges::count_if(raster.hits(), [](const Hit& hit) { return hit.nearness > 0.0F; })));
    for (int y = 0; y < grid.height; ++y) {
        for (int x = 0; x < grid.width; ++x) {
            const Hit& hit = raster.hits()[grid.at(x, y)];
            if (hit.nearness == 0.0F) continue;
            Sample sample{Vector3f::Zero(), Vector3f::Zero(), Vector3f::Zero(),
                          static_cast<std::uint32_t>(y / per_side * size.width + x / per_side)};
            for (std::size_t k = 0; k < 3; ++k) {
                const Mesh::Vertex& vertex = mesh.vertices[mesh.triangles[hit.triangle][k]];
                const float weight = hit.weights[k];
                sample.place += weight * vertex.place;
                sample.normal += weight * vertex.normal;
                sample.colour += weight * vertex.colour;
            }
            sample.normal.normalize();
            if (sample.normal.dot(eye - sample.place) < 0.0F) sample.normal = -sample.normal;
            samples.push_back(sample);
        }
    }
    return samples;
}

DepthMap::DepthMap(const Mesh& mesh, const Vector3f& to_light, int texels)
    : across_(to_light.unitOrthogonal()),
      up_(to_light.cross(across_)),
      to_light_(to_light),
      texels_{texels, texels},
      depth_(texels_.count(), -std::numeric_limits<float>::infinity()),
      blocks_{(texels + kBlock - 1) / kBlock, (texels + kBlock - 1) / kBlock},
      block_depth_(blocks_.count(), -std::numeric_limits<float>::infinity()) {
    Eigen::AlignedBox2f box;
    for (const Mesh::Vertex& vertex : mesh.vertices)
        box.extend(Vector2f(across_.dot(vertex.place), up_.dot(vertex.place)));
    x0_ = box.min().x();
    y0_ = box.min().y();
    texels_per_metre_ = static_cast<float>(texels - 1) / std::max(box.sizes().maxCoeff(), 1e-9F);
    for (const auto& ends : mesh.triangles) {
        std::array<Vector2f, 3> corners;
        Vector3f depths;
        for (std::size_t k = 0; k < 3; ++k) {
            const Vector3f& place = mesh.vertices[ends[k]].place;
            corners[k] = {(across_.dot(place) - x0_) * texels_per_metre_,
                          (up_.dot(place) - y0_) * texels_per_metre_};
            depths[k] = to_light_.dot(place);
        }
        for_each_point(corners, texels_, [&](int x, int y, const Vector3f& weights) {
            const float found = weights.dot(depths);
            float& depth = depth_[texels_.at(x, y)];
            float& block = block_depth_[blocks_.at(x / kBlock, y / kBlock)];
            depth = std::max(depth, found);
            block = std::max(block, found);
        });
    }
}

bool DepthMap::is_lit(const Vector3f& place) const {
    const float across = (across_.dot(place) - x0_) * texels_per_metre_ + 0.5F;
    const float up = (up_.dot(place) - y0_) * texels_per_metre_ + 0.5F;
    const auto end = static_cast<float>(texels_.width);
    if (!(across >= 0.0F && up >= 0.0F && across < end && up < end)) return true;
    const auto x = static_cast<int>(across);
    const auto y = static_cast<int>(up);
    const float depth = to_light_.dot(place) + 0.5F * texel_size();
    return block_depth_[blocks_.at(x / kBlock, y / kBlock)] <= depth || depth_[texels_.at(x, y)] <= depth;
}

}  // namespace fretwork::exports::detail
