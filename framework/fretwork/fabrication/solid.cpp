// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/fabrication/detail/triangulation.hpp>
#include <fretwork/fabrication/solid.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace fretwork::fabrication {
namespace {

using geometry::Box;
using geometry::Point2;
using geometry::Polygon;

class SolidMaker {
  public:
    SolidMaker(const Shape& shape, const SolidOptions& options)
        : options_(options), height_(shape.height), grid_(grid_of(shape)) {}

    void add(const Piece& piece) {
        options_.control.check();
        std::vector<Polygon> lines = {corners(piece.outer)};
        for (const Contour& opening : piece.openings) lines.push_back(corners(opening));
        std::erase_if(lines, [](const Polygon& line) { return line.size() < 3; });
        const auto caps = detail::triangulated(lines);
        options_.control.check();
        const int first = static_cast<int>(solid_.vertices.size());
        add_vertices(lines);
        const int count = (static_cast<int>(solid_.vertices.size()) - first) / 2;
        for (const auto& [a, b, c] : caps) {
            solid_.triangles.push_back({first + c, first + b, first + a});
            solid_.triangles.push_back({first + count + a, first + count + b, first + count + c});
        }
        add_walls(lines, first, count);
    }
    [[nodiscard]] Solid take() && { return std::move(solid_); }

  private:
    static double grid_of(const Shape& shape) {
        const Box box = box_of(shape);
        const double size =
            std::max({std::abs(box.xmin), std::abs(box.xmax), std::abs(box.ymin), std::abs(box.ymax)});
        return std::max(1e-7, std::ldexp(size, -22));
    }

    /// The ends of chords, rounded to the grid. Ends that fall together are one.
    [[nodiscard]] Polygon corners(const Contour& contour) const {
        Polygon line;
        for (const Point2& point : flattened(contour, options_.chord_tolerance)) {
            const Point2 on_grid{std::round(point.x / grid_) * grid_, std::round(point.y / grid_) * grid_};
            if (line.empty() || !(line.back() == on_grid)) line.push_back(on_grid);
        }
        while (line.size() > 1 && line.front() == line.back()) line.pop_back();
        return line;
    }

    void add_vertices(const std::vector<Polygon>& lines) {
        for (const double z : {0.0, height_})
            for (const Polygon& line : lines)
                for (const Point2& point : line) solid_.vertices.push_back({point.x, point.y, z});
    }

    /// Material lies on the left of the lines, so walls look to the right.
    void add_walls(const std::vector<Polygon>& lines, int first, int count) {
        int start = first;
        for (const Polygon& line : lines) {
            const int size = static_cast<int>(line.size());
            for (int i = 0; i < size; ++i) {
                const int a = start + i;
                const int b = start + (i + 1) % size;
                solid_.triangles.push_back({a, b, b + count});
                solid_.triangles.push_back({a, b + count, a + count});
            }
            start += size;
        }
    }

    const SolidOptions& options_;
    double height_;
    double grid_;
    Solid solid_;
};

}  // namespace

void SolidOptions::validate() const {
    if (std::isfinite(chord_tolerance) && chord_tolerance >= 1e-7) return;
    throw base::InputError("the tolerance of chords is " + base::format_number(chord_tolerance) +
                           " m, where 1e-7 m or more is needed");
}

Solid make_solid(const Shape& shape, const SolidOptions& options) {
    options.validate();
    SolidMaker maker(shape, options);
    for (const Piece& piece : shape.pieces) maker.add(piece);
    Solid solid = std::move(maker).take();
    if (const std::size_t open = check(solid).open_edges; open > 0)
        throw base::GeometryError("the outline touches itself: " + std::to_string(open) +
                                  " edges of its solid would not be closed");
    return solid;
}

double volume(const Solid& solid) {
    double sum = 0.0;
    for (const auto& [a, b, c] : solid.triangles) {
        const auto& p = solid.vertices[a];
        const auto& q = solid.vertices[b];
        const auto& r = solid.vertices[c];
        sum += p[0] * (q[1] * r[2] - q[2] * r[1]) + p[1] * (q[2] * r[0] - q[0] * r[2]) +
               p[2] * (q[0] * r[1] - q[1] * r[0]);
    }
    return sum / 6.0;
}

SolidCheck check(const Solid& solid) {
    std::vector<std::pair<int, int>> edges;
    edges.reserve(3 * solid.triangles.size());
    for (const auto& triangle : solid.triangles)
        for (std::size_t i = 0; i < 3; ++i) edges.emplace_back(triangle[i], triangle[(i + 1) % 3]);
    std::sort(edges.begin(), edges.end());
    SolidCheck result;
    for (std::size_t i = 0; i < edges.size(); ++i) {
        const bool repeated =
            (i > 0 && edges[i] == edges[i - 1]) || (i + 1 < edges.size() && edges[i] == edges[i + 1]);
        const std::pair opposite{edges[i].second, edges[i].first};
        if (repeated || !std::binary_search(edges.begin(), edges.end(), opposite)) ++result.open_edges;
    }
    result.euler_number = static_cast<long>(solid.vertices.size()) - static_cast<long>(edges.size() / 2) +
                          static_cast<long>(solid.triangles.size());
    return result;
}

}  // namespace fretwork::fabrication
