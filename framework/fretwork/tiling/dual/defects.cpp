// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/geometry/plane.hpp>
#include <fretwork/outlines/outline_check.hpp>
#include <fretwork/tiling/dual/cell_sides.hpp>
#include <fretwork/tiling/dual/defects.hpp>
#include <fretwork/tiling/dual/rim_of_dual.hpp>

#include <algorithm>
#include <set>

namespace fretwork::tiling::detail {
namespace {

using geometry::Point2;
using geometry::Polygon;

/// If too much is uncovered, each place is named whose area is above this share of the allowed area.
constexpr double kNotableShare = 0.02;

/// The areas between a stretch of a curve and the straight line through its ends, on the right and on the
/// left of this line.
struct SideAreas {
    double right = 0.0;
    double left = 0.0;
};

SideAreas areas_beside_chord(const Polygon& stretch) {
    const Point2 from = stretch.front();
    const double chord = distance(from, stretch.back());
    if (chord <= 0) return {};
    const Point2 along = (1 / chord) * (stretch.back() - from);
    SideAreas areas;
    const auto add = [&](double width, double mean_height) {
        (mean_height < 0 ? areas.right : areas.left) += width * std::abs(mean_height);
    };
    for (std::size_t i = 0; i + 1 < stretch.size(); ++i) {
        const Point2 a{dot(along, stretch[i] - from), cross(along, stretch[i] - from)};
        const Point2 b{dot(along, stretch[i + 1] - from), cross(along, stretch[i + 1] - from)};
        if ((a.y < 0) == (b.y < 0)) {
            add(b.x - a.x, 0.5 * (a.y + b.y));
        } else {
            const double crossing = a.x + (b.x - a.x) * a.y / (a.y - b.y);
            add(crossing - a.x, 0.5 * a.y);
            add(b.x - crossing, 0.5 * b.y);
        }
    }
    return areas;
}

class Comparison {
  public:
    Comparison(const Dual& dual, const Rim& rim, const SizeField& field, const QualityLimits& limits)
        : dual_(dual), rim_(rim), field_(field), limits_(limits) {
        for (const ClosedCurve& curve : rim.curves) {
            outline_area_ += geometry::signed_area(curve.stretch(0, curve.length()));
        }
    }

    Shape run(const base::Control& control) {
        for (std::size_t cell = 0; cell < dual_.cells.size(); ++cell) {
            control.check();
            check_shape(cell);
        }
        check_sides(control);
        check_rim(control);
        return std::move(shape_);
    }

  private:
    [[nodiscard]] const DualVertex& vertex(DualVertexIndex v) const { return dual_.vertices[v]; }
    void note(DefectKind kind, Point2 place, std::vector<std::size_t> cells = {}) {
        shape_.defects.push_back({kind, place, std::move(cells)});
    }

    void check_shape(std::size_t cell) {
        const Polygon polygon = polygon_of(dual_, cell);
        if (!geometry::is_convex(polygon)) return note(DefectKind::NotConvex, middle(polygon), {cell});
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            const Point2 here = polygon[(i + 1) % polygon.size()];
            const Point2 next = polygon[(i + 2) % polygon.size()];
            if (std::abs(turn(next - here, polygon[i] - here)) < limits_.smallest_angle)
                return note(DefectKind::SharpAngle, here, {cell});
        }
    }
    static Point2 middle(const Polygon& polygon) {
        Point2 sum{};
        for (const Point2& point : polygon) sum = sum + point;
        return (1.0 / static_cast<double>(polygon.size())) * sum;
    }

    void check_sides(const base::Control& control) {
        const auto sides = sides_of_cells(dual_, control);
        for_each_side(sides, control, [&](std::span<const CellSide> same) {
            const Point2 from = vertex(same.front().from).place;
            const Point2 to = vertex(same.front().to).place;
            std::vector<std::size_t> cells;
            for (const CellSide& side : same) cells.push_back(side.cell);
            const double usual = std::min(mean_side_beside(dual_, same), field_.largest());
            if (distance(from, to) < std::max(limits_.side_share * usual, limits_.smallest_side))
                note(DefectKind::ShortSide, between(from, to, 0.5), std::move(cells));
        });
    }

    void check_rim(const base::Control& control) {
        const Pieces pieces = pieces_of(dual_, control);
        if (pieces.count != 1)
            note(DefectKind::Torn, pieces.count == 0 ? rim_.points.front().place
                                                     : middle(polygon_of(dual_, pieces.cell_of_smallest)));
        const DualRim lines = rim_of(dual_, control);
        for (const DualVertexIndex knot : lines.knots) note(DefectKind::Torn, vertex(knot).place);
        std::set<LoopIndex> seen;
        for (const auto& line : lines.lines) check_line(line, seen);
        for (const LoopIndex loop : rim_.curves.indices()) {
            if (!seen.contains(loop)) note(DefectKind::Torn, rim_.curves[loop].at(0));
        }
        check_crossings(lines, control);
        shape_.covered_share = 1 - uncovered_ / outline_area_;
        shape_.outside_share = outside_ / outline_area_;
        if (shape_.covered_share < limits_.covered_share) note_uncovered();
    }

    /// Check that a line of the rim belongs to one loop of the outline and follows it once around.
    void check_line(const std::vector<DualVertexIndex>& line, std::set<LoopIndex>& seen) {
        const LoopIndex loop = vertex(line.front()).loop;
        const auto stranger = std::ranges::find_if(
            line, [&](DualVertexIndex v) { return !vertex(v).loop.is_valid() || vertex(v).loop != loop; });
        if (stranger != line.end()) return note(DefectKind::Torn, vertex(*stranger).place);
        if (line.size() < 3 || !seen.insert(loop).second)
            return note(DefectKind::Torn, vertex(line.front()).place);
        const ClosedCurve& curve = rim_.curves[loop];
        // A vertex that divides a side may lie on the line between its neighbours instead.
        std::vector<DualVertexIndex> on_curve;
        std::ranges::copy_if(line, std::back_inserter(on_curve), [&](DualVertexIndex v) {
            return !vertex(v).divides_side || distance(curve.at(vertex(v).along), vertex(v).place) == 0;
        });
        double way_around = 0.0;
        for (std::size_t i = 0; i < on_curve.size(); ++i) {
            const double from = vertex(on_curve[i]).along;
            const double way = curve.way(from, vertex(on_curve[(i + 1) % on_curve.size()]).along);
            way_around += way;
            measure(curve.stretch(from, from + way), vertex(on_curve[i]).place);
        }
        if (way_around > 1.5 * curve.length()) note(DefectKind::Torn, vertex(line.front()).place);
    }
    void measure(const Polygon& stretch, Point2 place) {
        const SideAreas areas = areas_beside_chord(stretch);
        uncovered_ += areas.right;
        outside_ += areas.left;
        gaps_.push_back({areas.right, between(place, stretch[stretch.size() / 2], 0.5)});
    }

    void check_crossings(const DualRim& lines, const base::Control& control) {
        const auto is_short = [](const auto& line) { return line.size() < 3; };
        if (lines.lines.empty() || std::ranges::any_of(lines.lines, is_short) || !lines.knots.empty()) return;
        for (const Point2& place : outlines::places_of_crossings(loops_of(dual_, lines), control))
            note(DefectKind::Torn, place);
    }

    /// Add a defect for each place with a large uncovered area.
    void note_uncovered() {
        const double allowed = (1 - limits_.covered_share) * outline_area_;
        for (const Gap& gap : gaps_) {
            if (gap.area > kNotableShare * allowed) note(DefectKind::Uncovered, gap.place);
        }
        if (gaps_.empty()) note(DefectKind::Uncovered, rim_.points.front().place);
    }

    struct Gap {
        double area;
        Point2 place;
    };

    const Dual& dual_;
    const Rim& rim_;
    const SizeField& field_;
    const QualityLimits& limits_;
    double outline_area_ = 0.0;
    double uncovered_ = 0.0;
    double outside_ = 0.0;
    std::vector<Gap> gaps_;
    Shape shape_;
};

}  // namespace

std::string_view words_for(DefectKind kind) {
    switch (kind) {
        case DefectKind::TooNarrow:
            return "no tile fits there";
        case DefectKind::TooMany:
            return "it would need too many tiles";
        case DefectKind::Torn:
            return "the tiles would not be connected as the outline is";
        case DefectKind::NotConvex:
            return "a tile would not be convex";
        case DefectKind::Uncovered:
            return "too much would stay uncovered";
        case DefectKind::ShortSide:
            return "a tile would have too short a side";
        case DefectKind::SharpAngle:
            return "a tile would have too sharp an angle";
    }
    return "";
}

Shape compare_with_outline(const Dual& dual, const Rim& rim, const SizeField& field,
                           const QualityLimits& limits, const base::Control& control) {
    return Comparison(dual, rim, field, limits).run(control);
}

}  // namespace fretwork::tiling::detail
