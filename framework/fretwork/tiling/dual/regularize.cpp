// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/geometry/plane.hpp>
#include <fretwork/tiling/dual/cell_sides.hpp>
#include <fretwork/tiling/dual/edits.hpp>
#include <fretwork/tiling/dual/rim_sides.hpp>

#include <algorithm>
#include <complex>
#include <numbers>

namespace fretwork::tiling::detail {
namespace {

using geometry::Point2;
using geometry::Polygon;

using Complex = std::complex<double>;

/// The roots of unity exp(2 pi i k / count) for each k, computed once for each count.
class RootsOfUnity {
  public:
    const std::vector<Complex>& of(std::size_t count) {
        if (roots_.size() <= count) roots_.resize(count + 1);
        std::vector<Complex>& roots = roots_[count];
        for (std::size_t k = roots.size(); k < count; ++k) {
            const double turns = static_cast<double>(k) / static_cast<double>(count);
            roots.push_back(std::polar(1.0, 2 * std::numbers::pi * turns));
        }
        return roots;
    }

  private:
    std::vector<std::vector<Complex>> roots_;
};

/// The regular polygon nearest to a polygon in the least-squares sense, by the mean and the first Fourier
/// coefficient of its vertices.
Polygon nearest_regular_polygon(const Polygon& polygon, const std::vector<Complex>& roots) {
    Complex mean;
    Complex first;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Complex place(polygon[i].x, polygon[i].y);
        mean += place;
        first += place * std::conj(roots[i]);
    }
    const double share = 1.0 / static_cast<double>(polygon.size());
    Polygon regular;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Complex place = share * (mean + first * roots[i]);
        regular.push_back({place.real(), place.imag()});
    }
    return regular;
}

// Cells with a sharper angle get a growing weight.
constexpr double kPullingAngle = 40 * std::numbers::pi / 180;
// Share of the cell's mean side; cells with a shorter side get a growing weight.
constexpr double kPullingSide = 0.4;
/// A turn() below minus this angle counts as straight, because rounding may make a straight angle reflex.
constexpr double kStraight = 170 * std::numbers::pi / 180;
constexpr double kHarder = 1.2;  // factor of the weight in each iteration
constexpr double kHardest = 10;
/// The weight of a side relative to its cell, when sides are made even. Inside, sides become nearly even
/// anyway, and a larger weight would spoil angles.
constexpr double kSidesAtRim = 2;
constexpr double kSidesInside = 0.5;
constexpr double kSlide = 0.9;  // largest share of the way to the neighbour along the rim

/// True if a cell has a reflex or sharp angle, or a short side.
bool is_far_from_regular(const Polygon& polygon) {
    const double mean = perimeter(polygon) / static_cast<double>(polygon.size());
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Point2 here = polygon[(i + 1) % polygon.size()];
        const Point2 side = polygon[(i + 2) % polygon.size()] - here;
        double angle = turn(side, polygon[i] - here);
        if (angle < -kStraight) angle += 2 * std::numbers::pi;
        if (angle < kPullingAngle || length(side) < kPullingSide * mean) return true;
    }
    return false;
}

class Regularizer {
  public:
    Regularizer(Dual& dual, const Rim& rim, const SizeField* field, const SharedTask& task)
        : dual_(dual), rim_(rim), field_(field), task_(task), weights_(dual.cells.size(), 1.0) {
        find_neighbors_on_rim();
    }

    void iterate() {
        sums_.assign(dual_.vertices.size(), {});
        weight_sums_.assign(dual_.vertices.size(), 0.0);
        for (std::size_t cell = 0; cell < dual_.cells.size(); ++cell) pull(cell);
        for (const DualVertexIndex v : dual_.vertices.indices()) {
            task_.check();
            if (weight_sums_[v] > 0 && !dual_.vertices[v].is_fixed)
                move(v, (1.0 / weight_sums_[v]) * sums_[v]);
        }
        for (const DualVertexIndex v : dual_.vertices.indices()) {
            if (dual_.vertices[v].divides_side && next_[v].is_valid()) keep_convex(v);
        }
    }

  private:
    void find_neighbors_on_rim() {
        previous_.resize(dual_.vertices.size());
        next_.resize(dual_.vertices.size());
        const auto sides = sides_of_cells(dual_, task_.control());
        for_each_side(sides, task_.control(), [&](std::span<const CellSide> same) {
            if (same.size() != 1) return;
            next_[same.front().from] = same.front().to;
            previous_[same.front().to] = same.front().from;
        });
    }

    void pull(std::size_t cell) {
        task_.check();
        const Polygon polygon = polygon_of(dual_, cell);
        double& weight = weights_[cell];
        weight = is_far_from_regular(polygon) ? std::min(kHardest, kHarder * weight)
                                              : std::max(1.0, weight / kHarder);
        if (field_) pull_sides(cell, polygon);
        const Polygon wanted = nearest_regular_polygon(polygon, roots_.of(polygon.size()));
        for (std::size_t i = 0; i < wanted.size(); ++i) add(dual_.cells[cell][i], wanted[i], weight);
    }

    /// Let each side pull or push its ends towards its wanted length.
    void pull_sides(std::size_t cell, const Polygon& polygon) {
        const Cell& vertices = dual_.cells[cell];
        const bool is_at_rim = std::ranges::any_of(
            vertices, [&](DualVertexIndex v) { return dual_.vertices[v].loop.is_valid(); });
        const double weight = is_at_rim ? kSidesAtRim : kSidesInside;
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            const std::size_t next = (i + 1) % polygon.size();
            const double side = distance(polygon[i], polygon[next]);
            if (!(side > 0)) continue;
            const Point2 middle = between(polygon[i], polygon[next], 0.5);
            const Point2 half = (0.5 * field_->at(middle) / side) * (polygon[next] - polygon[i]);
            add(vertices[i], middle - half, weight);
            add(vertices[next], middle + half, weight);
        }
    }
    void add(DualVertexIndex v, Point2 wanted, double weight) {
        sums_[v] = sums_[v] + weight * wanted;
        weight_sums_[v] += weight;
    }

    void move(DualVertexIndex v, Point2 wanted) {
        DualVertex& vertex = dual_.vertices[v];
        if (!vertex.loop.is_valid()) {
            vertex.place = wanted;
            return;
        }
        const ClosedCurve& curve = rim_.curves[vertex.loop];
        const double back = kSlide * way(previous_[v], v);
        const double forth = kSlide * way(v, next_[v]);
        vertex.along = curve.nearest_between(vertex.along - back, vertex.along + forth, wanted);
        vertex.place = curve.at(vertex.along);
    }
    /// Keep the cell convex at a vertex that divides a side, after its neighbours have moved.
    void keep_convex(DualVertexIndex v) {
        DualVertex& vertex = dual_.vertices[v];
        const auto place = [&](DualVertexIndex other) { return dual_.vertices[other].place; };
        const ClosedCurve& curve = rim_.curves[vertex.loop];
        vertex.place = convex_place(curve.at(vertex.along), {place(previous_[v]), place(next_[v])});
    }
    /// The distance along the outline from one vertex forward to another; 0 if the other is not in front.
    [[nodiscard]] double way(DualVertexIndex from, DualVertexIndex to) const {
        if (!from.is_valid() || !to.is_valid()) return 0.0;
        const DualVertex& a = dual_.vertices[from];
        const DualVertex& b = dual_.vertices[to];
        if (a.loop != b.loop) return 0.0;
        const ClosedCurve& curve = rim_.curves[a.loop];
        const double forward = curve.way(a.along, b.along);
        return forward < 0.9 * curve.length() ? forward : 0.0;
    }

    Dual& dual_;
    const Rim& rim_;
    const SizeField* field_;  // wanted sides, towards which sides pull; null: sides do not pull
    const SharedTask& task_;
    RootsOfUnity roots_;
    std::vector<double> weights_;
    // Previous vertex of each vertex of the rim.
    base::IndexVector<DualVertexIndex, DualVertexIndex> previous_;
    base::IndexVector<DualVertexIndex, DualVertexIndex> next_;
    base::IndexVector<DualVertexIndex, Point2> sums_;
    base::IndexVector<DualVertexIndex, double> weight_sums_;
};

}  // namespace

void regularize(Dual& dual, const Rim& rim, int iterations, const SharedTask& task) {
    Regularizer regularizer(dual, rim, nullptr, task);
    for (int iteration = 0; iteration < iterations; ++iteration) regularizer.iterate();
}

void even_out(Dual& dual, const Rim& rim, const SizeField& field, int iterations, const SharedTask& task) {
    Regularizer regularizer(dual, rim, &field, task);
    for (int iteration = 0; iteration < iterations; ++iteration) regularizer.iterate();
}

}  // namespace fretwork::tiling::detail
