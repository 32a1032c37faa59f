// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/geometry/plane.hpp>
#include <fretwork/tiling/dual/cell_sides.hpp>
#include <fretwork/tiling/dual/rim_sides.hpp>

#include <algorithm>

namespace fretwork::tiling::detail {
namespace {

using geometry::Point2;
using geometry::Polygon;

/// The ratio of a side to the usual side above which the side is divided. At sqrt(2), the halves are as far
/// from the usual side as the whole. The limit is a little smaller, because the rim's sides shrink when the
/// tiles are made even.
constexpr double kLong = 1.3;
// Smallest distance of a dividing vertex from the ends of the chord, as a share of the chord.
constexpr double kNearestToEnd = 0.1;
/// The first and the largest distance by which a vertex on a chord is put outside the chord, as shares of the
/// chord. The distance grows as long as rounding puts the vertex inside.
constexpr double kLeastBulge = 1e-12;
constexpr double kMostBulge = 1e-4;
constexpr std::size_t kMostSides = 6;  // largest number of sides of a cell with a divided side

class Divider {
  public:
    Divider(Dual& dual, const Rim& rim, const WantedSides& wanted)
        : dual_(dual), rim_(rim), wanted_(wanted) {}

    void run(const base::Control& control) {
        const auto sides = sides_of_cells(dual_, control);
        for_each_side(sides, control, [&](std::span<const CellSide> same) {
            if (same.size() == 1 && is_to_be_divided(same.front())) divide(same.front());
        });
    }

  private:
    [[nodiscard]] const DualVertex& vertex(DualVertexIndex v) const { return dual_.vertices[v]; }

    [[nodiscard]] bool is_to_be_divided(const CellSide& side) const {
        const DualVertex& from = vertex(side.from);
        const DualVertex& to = vertex(side.to);
        if (!from.loop.is_valid() || from.loop != to.loop || dual_.cells[side.cell].size() >= kMostSides)
            return false;
        const ClosedCurve& curve = rim_.curves[from.loop];
        // The side runs backwards, or along more than half of the curve.
        if (curve.way(from.along, to.along) > 0.5 * curve.length()) return false;
        const double length = distance(from.place, to.place);
        return length > kLong * usual_side(side) && length > 2 * wanted_.smallest;
    }
    /// The wanted side or, in narrow parts, the mean of the cell's other sides if this mean is larger.
    [[nodiscard]] double usual_side(const CellSide& side) const {
        const Polygon polygon = polygon_of(dual_, side.cell);
        const Point2 from = vertex(side.from).place;
        const Point2 to = vertex(side.to).place;
        const double others = perimeter(polygon) - distance(from, to);
        return std::max(wanted_.field.at(between(from, to, 0.5)),
                        others / static_cast<double>(polygon.size() - 1));
    }

    void divide(const CellSide& side) {
        const DualVertex& from = vertex(side.from);
        const ClosedCurve& curve = rim_.curves[from.loop];
        const double along = from.along + 0.5 * curve.way(from.along, vertex(side.to).along);
        DualVertex middle{curve.at(along), from.loop, false, along, true};
        middle.place = convex_place(middle.place, {from.place, vertex(side.to).place});
        Cell& cell = dual_.cells[side.cell];
        cell.insert(std::ranges::find(cell, side.from) + 1, DualVertexIndex(dual_.vertices.size()));
        dual_.vertices.push_back(middle);
    }

    Dual& dual_;
    const Rim& rim_;
    const WantedSides& wanted_;
};

}  // namespace

Point2 convex_place(Point2 wanted, const StraightSide& side) {
    const auto is_inside = [&](Point2 place) { return geometry::is_convex({side.from, side.to, place}); };
    if (!is_inside(wanted)) return wanted;
    const Point2 along = side.to - side.from;
    const double share = dot(wanted - side.from, along) / dot(along, along);
    const Point2 nearest = between(side.from, side.to, std::clamp(share, kNearestToEnd, 1 - kNearestToEnd));
    Point2 place = nearest;
    for (double bulge = kLeastBulge; is_inside(place) && bulge < kMostBulge; bulge *= 10)
        place = nearest + bulge * Point2{along.y, -along.x};
    return place;
}

void divide_long_rim_sides(Dual& dual, const Rim& rim, const WantedSides& wanted,
                           const base::Control& control) {
    Divider(dual, rim, wanted).run(control);
}

}  // namespace fretwork::tiling::detail
