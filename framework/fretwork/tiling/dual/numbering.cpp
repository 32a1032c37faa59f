// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/geometry/plane.hpp>
#include <fretwork/pattern/rational.hpp>
#include <fretwork/tiling/dual/numbering.hpp>

#include <algorithm>
#include <complex>
#include <numbers>

namespace fretwork::tiling::detail {
namespace {

using geometry::Point2;
using geometry::Polygon;

constexpr double kPi = std::numbers::pi;

/// The direction in which a side faces, away from the tile.
double facing(Point2 from, Point2 to) {
    return std::atan2(from.x - to.x, to.y - from.y);
}

/// The direction in which the first sides of tiles should face: straight down, adjusted by at most 30 degrees
/// to a direction that sides of most hexagons face. In this way, equal tiles get equal orientations, also if
/// two sides are equally near to straight down.
double first_side_facing(const Dual& dual, const base::Control& control) {
    std::complex<double> sixfold;
    for (std::size_t cell = 0; cell < dual.cells.size(); ++cell) {
        control.check();
        const Polygon polygon = polygon_of(dual, cell);
        if (polygon.size() != 6) continue;
        for (std::size_t i = 0; i < 6; ++i)
            sixfold += std::polar(1.0, 6 * facing(polygon[i], polygon[(i + 1) % 6]));
    }
    const double down = -kPi / 2;
    // The sixfold direction of "straight down" is exp(6 i down) = -1.
    double off = std::abs(sixfold) > 0 ? std::arg(-sixfold) / 6 : 0;
    if (off < -kPi / 6 + 1e-6) off += kPi / 3;  // both ends of the range mean the same; take one of them
    return down + off;
}

/// The index of the vertex that becomes vertex 0: the first vertex of the side that faces nearest to a
/// direction.
std::size_t first_vertex(const Polygon& polygon, double wanted_facing) {
    std::size_t best = 0;
    double best_off = 4;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const double off = std::abs(
            std::remainder(facing(polygon[i], polygon[(i + 1) % polygon.size()]) - wanted_facing, 2 * kPi));
        if (off < best_off - 1e-9) {
            best = i;
            best_off = off;
        }
    }
    return best;
}

/// The cells from left to right, and from bottom to top if they have the same x.
std::vector<std::size_t> from_left_to_right(const Dual& dual, const base::Control& control) {
    std::vector<std::pair<double, double>> keys;
    for (std::size_t cell = 0; cell < dual.cells.size(); ++cell) {
        control.check();
        const Point2 middle = geometry::centroid(polygon_of(dual, cell));
        keys.emplace_back(middle.x, middle.y);
    }
    std::vector<std::size_t> order(dual.cells.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return keys[a] < keys[b]; });
    return order;
}

class Numberer {
  public:
    Numberer(const Dual& dual, const pattern::NodeLayout& layout, const base::Control& control)
        : dual_(dual), control_(control), numbers_(dual.vertices.size()), sides_(dual.vertices.size()) {
        result_.layout = layout.name();
        for (const pattern::Rational& place : layout.description().interface)
            places_.push_back(place.to_double());
    }

    Tessellation run() {
        const double facing = first_side_facing(dual_, control_);
        for (const std::size_t cell : from_left_to_right(dual_, control_)) {
            control_.check();
            Cell vertices = dual_.cells[cell];
            const std::ptrdiff_t first = first_vertex(polygon_of(dual_, cell), facing);
            std::rotate(vertices.begin(), vertices.begin() + first, vertices.end());
            add_tile(vertices);
        }
        return std::move(result_);
    }

  private:
    void add_tile(const Cell& vertices) {
        Tile tile;
        for (const DualVertexIndex vertex : vertices) tile.vertices.push_back(number_of(vertex));
        for (std::size_t i = 0; i < vertices.size(); ++i) {
            const auto nodes = nodes_on_side(tile.vertices[i], tile.vertices[(i + 1) % vertices.size()]);
            tile.interface_nodes.insert(tile.interface_nodes.end(), nodes.begin(), nodes.end());
        }
        result_.tiles.push_back(std::move(tile));
    }

    VertexIndex number_of(DualVertexIndex v) {
        if (!numbers_[v].is_valid()) {
            numbers_[v] = VertexIndex(result_.vertices.size());
            result_.vertices.push_back(dual_.vertices[v].place);
        }
        return numbers_[v];
    }

    /// The interface nodes on a side in this direction. The neighbour has the same nodes in the opposite
    /// direction.
    std::vector<InterfaceIndex> nodes_on_side(VertexIndex from, VertexIndex to) {
        std::vector<InterfaceIndex> nodes;
        for (const Side& other : sides_[to]) {
            if (other.to != from) continue;
            for (std::size_t i = places_.size(); i-- > 0;) nodes.emplace_back(other.first_node + i);
            return nodes;
        }
        sides_[from].push_back({to, result_.interface_nodes.size()});
        const Point2 a = result_.vertices[from];
        const Point2 b = result_.vertices[to];
        for (const double place : places_) {
            nodes.emplace_back(result_.interface_nodes.size());
            result_.interface_nodes.push_back(between(a, b, place));
        }
        return nodes;
    }

    const Dual& dual_;
    const base::Control& control_;
    std::vector<double> places_;  // places of the interface nodes, as shares of a side
    Tessellation result_;
    base::IndexVector<DualVertexIndex, VertexIndex> numbers_;
    /// A side that a tile has, and the number of its first interface node.
    struct Side {
        VertexIndex to;
        std::size_t first_node;
    };
    base::IndexVector<VertexIndex, std::vector<Side>> sides_;  // sides by their first vertex
};

}  // namespace

Tessellation number(const Dual& dual, const pattern::NodeLayout& layout, const base::Control& control) {
    return Numberer(dual, layout, control).run();
}

}  // namespace fretwork::tiling::detail
