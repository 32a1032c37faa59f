// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/geometry/plane.hpp>
#include <fretwork/tiling/dual/cell_sides.hpp>
#include <fretwork/tiling/dual/rim_sides.hpp>

#include <algorithm>

namespace fretwork::tiling::detail {
namespace {

using geometry::Point2;
using geometry::Polygon;

/// Over the sides usual there. Halves of sqrt(2) are as far from them as the whole; the rim's sides shrink
/// when the tiles are made even, so the limit is a little less.
constexpr double kLong = 1.3;
constexpr double kNearestToEnd = 0.1;  // of a chord: so far from its ends is a vertex on it at least
/// The distance by which a vertex on a chord is put outside of it, in its lengths: first, and last if
/// rounding puts it inside.
constexpr double kLeastBulge = 1e-12;
constexpr double kMostBulge = 1e-4;
constexpr std::size_t kMostSides = 6;  // of a cell with a divided side

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
        if (curve.way(from.along, to.along) > 0.5 * curve.length()) return false;  // backwards, or all around
        const double length = distance(from.place, to.place);
        return length > kLong * usual_side(side) && length > 2 * wanted_.smallest;
    }
    /// The wanted side, or in narrow parts the mean of the cell's other sides, if they are longer.
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
