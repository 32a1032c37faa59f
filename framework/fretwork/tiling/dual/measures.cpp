// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/geometry/plane.hpp>
#include <fretwork/tiling/dual/cell_sides.hpp>
#include <fretwork/tiling/dual/measures.hpp>

#include <algorithm>
#include <limits>
#include <numbers>

namespace fretwork::tiling::detail {
namespace {

using geometry::Point2;
using geometry::Polygon;

/// The area, as a share of a regular hexagon's area, below which a tile is small. Small tiles are mostly at
/// corners of the outline, and their bars merge to a knot.
constexpr double kSmall = 0.25;
constexpr double kHexagon = 1.5 * std::numbers::sqrt3;  // area of a regular hexagon with sides of 1

/// The mean and the standard deviation of the added values.
class Spread {
  public:
    void add(double value) {
        count_ += 1.0;
        sum_ += value;
        sum_of_squares_ += value * value;
    }
    [[nodiscard]] double mean() const { return sum_ / count_; }
    [[nodiscard]] double deviation() const {
        return std::sqrt(std::max(0.0, sum_of_squares_ / count_ - mean() * mean()));
    }
    [[nodiscard]] double relative() const { return deviation() / mean(); }

  private:
    double count_ = 0.0;
    double sum_ = 0.0;
    double sum_of_squares_ = 0.0;
};

bool is_at_rim(const Dual& dual, const Cell& cell) {
    return std::ranges::any_of(cell, [&](DualVertexIndex v) { return dual.vertices[v].loop.is_valid(); });
}

double smallest_angle(const Polygon& polygon) {
    double smallest = std::numbers::pi;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Point2 here = polygon[(i + 1) % polygon.size()];
        const Point2 next = polygon[(i + 2) % polygon.size()];
        smallest = std::min(smallest, std::abs(turn(next - here, polygon[i] - here)));
    }
    return smallest;
}

/// The spread of the ratio of sides to wanted sides.
Spread measure_sides(const Dual& dual, const SizeField& field, const base::Control& control,
                     TessellationReport& report) {
    Spread lengths;
    Spread ratios;
    report.smallest_side = std::numeric_limits<double>::infinity();
    const auto sides = sides_of_cells(dual, control);
    for_each_side(sides, control, [&](std::span<const CellSide> same) {
        const Point2 from = dual.vertices[same.front().from].place;
        const Point2 to = dual.vertices[same.front().to].place;
        const double side = distance(from, to);
        lengths.add(side);
        ratios.add(side / field.at(between(from, to, 0.5)));
        report.smallest_side = std::min(report.smallest_side, side);
        report.largest_side = std::max(report.largest_side, side);
    });
    report.mean_side = lengths.mean();
    report.sd_side = lengths.deviation();
    return ratios;
}

}  // namespace

Measures measure(const Dual& dual, const SizeField& field, const base::Control& control) {
    Measures result;
    TessellationReport& report = result.report;
    const Spread sides = measure_sides(dual, field, control, report);
    report.smallest_angle = std::numbers::pi;
    report.tiles = static_cast<int>(dual.cells.size());
    int hexagons = 0;
    int inner = 0;
    int inner_hexagons = 0;
    int misfits = 0;
    int refined = 0;
    int small = 0;
    Spread areas;
    for (std::size_t cell = 0; cell < dual.cells.size(); ++cell) {
        control.check();
        const Polygon polygon = polygon_of(dual, cell);
        const bool at_rim = is_at_rim(dual, dual.cells[cell]);
        const bool is_hexagon = polygon.size() == 6;
        hexagons += is_hexagon ? 1 : 0;
        inner += at_rim ? 0 : 1;
        inner_hexagons += !at_rim && is_hexagon ? 1 : 0;
        misfits += is_hexagon || (at_rim && polygon.size() == 5) ? 0 : 1;
        const double wanted = field.at(polygon.front());
        refined += wanted < field.largest() ? 1 : 0;
        const double area = geometry::signed_area(polygon) / (wanted * wanted);
        areas.add(area);
        small += area < kSmall * kHexagon ? 1 : 0;
        report.smallest_angle = std::min(report.smallest_angle, smallest_angle(polygon));
    }
    const auto count = static_cast<double>(report.tiles);
    report.hexagon_share = hexagons / count;
    report.inner_tiles = inner;
    report.inner_hexagon_share = inner > 0 ? static_cast<double>(inner_hexagons) / inner : 0.0;
    report.refined_share = refined / count;
    result.mean_ratio = sides.mean();
    result.irregularity = small + misfits / count + sides.relative() + areas.relative();
    return result;
}

}  // namespace fretwork::tiling::detail
