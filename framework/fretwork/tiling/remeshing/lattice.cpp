// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/geometry/plane.hpp>
#include <fretwork/geometry/point_grid.hpp>
#include <fretwork/tiling/remeshing/inside.hpp>
#include <fretwork/tiling/remeshing/sites.hpp>

#include <algorithm>
#include <numbers>

namespace fretwork::tiling::detail {
namespace {

using geometry::Point2;

/// The margin of sites from the rim, half of a tile's width, so that tiles at the rim are about as large as
/// tiles inside.
constexpr double kLatticeMargin = 0.45;  // share of the spacing
constexpr double kFinerBy = 0.75;        // factor from one lattice to the next finer lattice
// Smallest distance between sites of different lattices, as a share of the wanted distance.
constexpr double kLeastDistance = 0.7;

/// The first and the last k within -reach .. reach for which start + k step may lie in the box with these
/// half sizes around the origin. This range saves time for a long, narrow outline, whose box has far fewer
/// lattice points than -reach .. reach has steps.
std::pair<int, int> steps_within(Point2 start, Point2 step, Point2 half, int reach) {
    double first = -reach;
    double last = reach;
    const auto narrow = [&](double from, double by, double bound) {
        if (std::abs(by) * reach < 1e-9 * bound) return;  // moves too little; the other direction decides
        const double one = (-bound - from) / by;
        const double other = (bound - from) / by;
        first = std::max(first, std::ceil(std::min(one, other) - 1e-6));
        last = std::min(last, std::floor(std::max(one, other) + 1e-6));
    };
    narrow(start.x, step.x, half.x);
    narrow(start.y, step.y, half.y);
    return {static_cast<int>(first), static_cast<int>(std::max(last, first - 1))};
}

/// A box, and a triangular lattice through its middle.
struct LatticeBox {
    Point2 middle;
    Point2 half;
    double edge;
    double angle;
};

/// Call body with each point of the lattice in the box.
template <class Body>
void for_each_lattice_point(const LatticeBox& box, const SharedTask& task, const Body& body) {
    const auto direction = [&](double angle) {
        return Point2{box.edge * std::cos(angle), box.edge * std::sin(angle)};
    };
    const Point2 along = direction(box.angle);
    const Point2 across = direction(box.angle + std::numbers::pi / 3);
    // Rows of a triangular lattice are sqrt(3)/2 apart.
    const int reach = static_cast<int>(std::ceil(2 * length(box.half) / box.edge)) + 1;
    for (int row = -reach; row <= reach; ++row) {
        task.check();
        const Point2 start = static_cast<double>(row) * across;
        const auto [first, last] = steps_within(start, along, box.half, reach);
        for (int column = first; column <= last; ++column) {
            task.check();
            body(box.middle + static_cast<double>(column) * along + start);
        }
    }
}

/// Add finer and finer lattices, as the limits of the side require, each where it fits.
void add_finer_lattices(const InsideTest& is_inside, const Spacing& spacing, double angle,
                        const SharedTask& task, std::vector<Point2>& sites) {
    geometry::PointGrid grid(spacing.largest());
    for (const Point2& site : sites) {
        task.check();
        grid.add(site);
    }
    const double finest = spacing.factor * spacing.field.smallest();
    const double half_step = std::sqrt(kFinerBy);
    for (double edge = spacing.largest() * kFinerBy; edge > half_step * finest; edge *= kFinerBy) {
        for (const SizeField::Square& square : spacing.field.limited_squares()) {
            const double off = spacing.factor * SizeField::kGrowth * std::numbers::sqrt2 * square.half_width;
            const double middle = spacing.at(square.middle);
            if (middle + off < half_step * edge || middle - off > edge / half_step) continue;
            const auto add = [&](Point2 site) {
                const double wanted = spacing.at(site);
                if (wanted < half_step * edge || wanted > edge / half_step) return;
                if (!is_inside(site, kLatticeMargin * wanted)) return;
                if (grid.has_near(site, kLeastDistance * wanted)) return;
                grid.add(site);
                sites.push_back(site);
            };
            for_each_lattice_point({square.middle, {square.half_width, square.half_width}, edge, angle}, task,
                                   add);
        }
    }
}

}  // namespace

std::vector<Point2> lattice_sites(const Rim& rim, const Spacing& spacing, double angle,
                                  const SharedTask& task) {
    Point2 low = rim.points.front().place;
    Point2 high = low;
    for (const RimPoint& point : rim.points) {
        low = {std::min(low.x, point.place.x), std::min(low.y, point.place.y)};
        high = {std::max(high.x, point.place.x), std::max(high.y, point.place.y)};
    }
    const double edge = spacing.largest();
    const InsideTest is_inside(rim, kLatticeMargin * edge, task.control());
    std::vector<Point2> sites;
    const double coarsest = std::sqrt(kFinerBy) * edge;
    for_each_lattice_point({between(low, high, 0.5), 0.5 * (high - low), edge, angle}, task,
                           [&](Point2 site) {
                               const double wanted = spacing.at(site);
                               if (wanted >= coarsest && is_inside(site, kLatticeMargin * wanted))
                                   sites.push_back(site);
                           });
    if (!spacing.field.is_uniform()) add_finer_lattices(is_inside, spacing, angle, task, sites);
    return sites;
}

}  // namespace fretwork::tiling::detail
