// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/geometry/box.hpp>
#include <fretwork/geometry/internal/segment_box.hpp>
#include <fretwork/geometry/plane.hpp>
#include <fretwork/geometry/point_grid.hpp>
#include <fretwork/outlines/detail/remarks.hpp>
#include <fretwork/outlines/regions/line_joining.hpp>

#include <CGAL/box_intersection_d.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <optional>
#include <tuple>

namespace fretwork::outlines::detail {
namespace {

using geometry::Point2;
using geometry::Polygon;

/// The two ends of each line as numbered points. Ends nearer to each other than the tolerance have the same
/// number.
class Ends {
  public:
    Ends(std::vector<Polygon>& lines, double same) : places_(same), same_(same) {
        for (Polygon& line : lines) numbers_.push_back({number_of(line.front()), number_of(line.back())});
    }
    [[nodiscard]] std::array<std::size_t, 2> of(std::size_t line) const { return numbers_[line]; }
    [[nodiscard]] std::size_t count() const { return places_.points().size(); }

  private:
    /// The number of an end. The end is moved to the point with this number.
    std::size_t number_of(Point2& end) {
        const std::size_t number = places_.number_of(end, same_);
        end = places_.points()[number];
        return number;
    }
    geometry::PointGrid places_;
    double same_;
    std::vector<std::array<std::size_t, 2>> numbers_;
};

double length_of(const Polygon& line) {
    double sum = 0;
    for (std::size_t i = 0; i + 1 < line.size(); ++i) sum += distance(line[i], line[i + 1]);
    return sum;
}

Point2 middle_of(const Polygon& line) {
    double rest = 0.5 * length_of(line);
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        const double step = distance(line[i], line[i + 1]);
        if (step >= rest && step > 0) return between(line[i], line[i + 1], rest / step);
        rest -= step;
    }
    return line.back();
}

/// Whether a side leads from the last point of a line to its first point.
enum class Form { Open, Closed };

/// True if the points of a line, or evenly chosen points of a long line, lie on another line up to `reach`.
bool lies_on(const Polygon& line, const Polygon& other, Form form, double reach) {
    constexpr std::size_t kMostCompared = 64;
    const std::size_t sides = form == Form::Closed ? other.size() : other.size() - 1;
    const std::size_t step = std::max<std::size_t>(1, line.size() / kMostCompared);
    for (std::size_t i = 0; i < line.size(); i += step) {
        bool is_near = false;
        for (std::size_t side = 0; side < sides && !is_near; ++side) {
            const Point2 to = other[(side + 1) % other.size()];
            is_near = distance(nearest_on_segment(other[side], to, line[i]), line[i]) <= reach;
        }
        if (!is_near) return false;
    }
    return true;
}

/// True if each of two lines lies on the other. The polygons of equal curves may have other points, and lie
/// apart by the tolerance of flattening, which is twice `same`.
bool lie_on_each_other(const Polygon& a, const Polygon& b, Form form, double same) {
    constexpr double kApart = 4;
    return lies_on(a, b, form, kApart * same) && lies_on(b, a, form, kApart * same);
}

/// True for each line with the same ends, middle, length and course as an earlier line.
std::vector<bool> find_doubled(const std::vector<Polygon>& lines, const Ends& ends, double same) {
    std::map<std::array<std::size_t, 2>, std::vector<std::size_t>> by_ends;
    std::vector<bool> is_doubled(lines.size(), false);
    for (std::size_t line = 0; line < lines.size(); ++line) {
        auto key = ends.of(line);
        std::ranges::sort(key);
        auto& others = by_ends[key];
        is_doubled[line] = std::ranges::any_of(others, [&](std::size_t other) {
            return distance(middle_of(lines[line]), middle_of(lines[other])) <= same &&
                   std::abs(length_of(lines[line]) - length_of(lines[other])) <= 2 * same &&
                   lie_on_each_other(lines[line], lines[other], Form::Open, same);
        });
        constexpr std::size_t kMostCompared = 64;
        if (!is_doubled[line] && others.size() < kMostCompared) others.push_back(line);
    }
    return is_doubled;
}

struct LooseEnd {
    Point2 place;
    std::size_t line;  // index of the joined line
};

/// The ends that no other line shares.
std::vector<LooseEnd> loose_ends(const JoinedLines& joined, const Ends& ends) {
    std::vector<int> degree(ends.count(), 0);
    for (const std::size_t given : joined.given)
        for (const std::size_t end : ends.of(given)) ++degree[end];
    std::vector<LooseEnd> loose;
    for (std::size_t line = 0; line < joined.lines.size(); ++line) {
        const auto numbers = ends.of(joined.given[line]);
        if (degree[numbers[0]] == 1) loose.push_back({joined.lines[line].front(), line});
        if (degree[numbers[1]] == 1) loose.push_back({joined.lines[line].back(), line});
    }
    return loose;
}

struct Gap {
    double width;
    std::size_t from;
    std::size_t to;
};

/// The largest number of pairs of loose ends that may be joined, 500 MB. Gravel in a site plan has millions.
constexpr std::size_t kMostGaps = 20'000'000;

[[noreturn]] void fail_gaps(Point2 place, double most) {
    throw base::GeometryError("more than " + std::to_string(kMostGaps) + " pairs of loose ends lie within " +
                              roughly_in_millimetres(most) + " mm of each other, one near (" +
                              in_millimetres(place.x) + ", " + in_millimetres(place.y) +
                              ") mm; join the lines in the drawing, or leave out those that are no outline");
}

std::vector<Gap> gaps_between(const std::vector<LooseEnd>& loose, const JoinedLines& joined, double most) {
    geometry::PointGrid grid(most);
    for (const LooseEnd& end : loose) grid.add(end.place);
    std::vector<Gap> gaps;
    for (std::size_t end = 0; end < loose.size(); ++end) {
        grid.visit_around(loose[end].place, [&](std::size_t other) {
            if (other <= end) return;
            const double width = distance(loose[end].place, loose[other].place);
            const bool is_itself = loose[end].line == loose[other].line;
            constexpr double kMuchLonger = 4;  // a shorter stroke is not joined to itself
            if (width <= most &&
                (!is_itself || length_of(joined.lines[loose[end].line]) > kMuchLonger * most))
                gaps.push_back({width, end, other});
            if (gaps.size() > kMostGaps) fail_gaps(loose[end].place, most);
        });
    }
    std::ranges::sort(gaps, {}, [](const Gap& gap) { return std::tuple(gap.width, gap.from, gap.to); });
    return gaps;
}

void close_gaps(JoinedLines& joined, const Ends& ends, double most) {
    const std::vector<LooseEnd> loose = loose_ends(joined, ends);
    std::vector<bool> is_joined(loose.size(), false);
    for (const Gap& gap : gaps_between(loose, joined, most)) {
        if (is_joined[gap.from] || is_joined[gap.to]) continue;
        is_joined[gap.from] = is_joined[gap.to] = true;
        joined.lines.push_back({loose[gap.from].place, loose[gap.to].place});
        joined.given.push_back(joined.given[loose[gap.from].line]);
        ++joined.gaps;
        joined.widest_gap = std::max(joined.widest_gap, gap.width);
    }
}

/// A side of a line, given by its first point.
struct Side {
    std::size_t line;
    std::size_t index;
};
using SideBox = CGAL::Box_intersection_d::Box_with_handle_d<double, 2, const std::size_t*>;

std::vector<Side> sides_of(const std::vector<Polygon>& lines) {
    std::vector<Side> sides;
    for (std::size_t line = 0; line < lines.size(); ++line)
        for (std::size_t i = 0; i + 1 < lines[line].size(); ++i) sides.push_back({line, i});
    return sides;
}

/// For each side (by number), the loose ends of other lines that lie on the side, but not at its ends.
std::map<std::size_t, std::vector<Point2>> ends_on(const std::vector<Side>& sides,
                                                   const std::vector<LooseEnd>& loose,
                                                   const JoinedLines& joined, double same) {
    std::vector<std::size_t> numbers(std::max(sides.size(), loose.size()));
    std::iota(numbers.begin(), numbers.end(), std::size_t{0});
    std::vector<SideBox> end_boxes;
    std::vector<SideBox> side_boxes;
    for (std::size_t i = 0; i < loose.size(); ++i)
        end_boxes.emplace_back(geometry::box_around(loose[i].place, loose[i].place, same), &numbers[i]);
    for (std::size_t i = 0; i < sides.size(); ++i) {
        const Polygon& line = joined.lines[sides[i].line];
        side_boxes.emplace_back(geometry::box_around(line[sides[i].index], line[sides[i].index + 1], same),
                                &numbers[i]);
    }
    std::map<std::size_t, std::vector<Point2>> found;
    const auto look = [&](const SideBox& a, const SideBox& b) {
        const LooseEnd& end = loose[*a.handle()];
        const Side& side = sides[*b.handle()];
        const Point2 from = joined.lines[side.line][side.index];
        const Point2 to = joined.lines[side.line][side.index + 1];
        if (end.line == side.line || distance(end.place, from) <= same || distance(end.place, to) <= same)
            return;
        if (distance(end.place, nearest_on_segment(from, to, end.place)) <= same)
            found[*b.handle()].push_back(end.place);
    };
    CGAL::box_intersection_d(end_boxes.begin(), end_boxes.end(), side_boxes.begin(), side_boxes.end(), look);
    return found;
}

/// Insert each loose end that lies on another line, up to rounding, as a point of that line.
void put_ends_on_lines(JoinedLines& joined, const Ends& ends, double same) {
    const std::vector<Side> sides = sides_of(joined.lines);
    auto found = ends_on(sides, loose_ends(joined, ends), joined, same);
    // From the last side of a line to the first, so that the indices of the remaining sides stay valid.
    for (auto on = found.rbegin(); on != found.rend(); ++on) {
        const Side& side = sides[on->first];
        Polygon& line = joined.lines[side.line];
        const Point2 from = line[side.index];
        std::ranges::sort(on->second, {}, [&](Point2 point) { return distance(point, from); });
        line.insert(line.begin() + side.index + 1, on->second.begin(), on->second.end());
    }
}

}  // namespace

JoinedLines join_lines(const std::vector<Polygon>& lines, const JoiningTolerance& tolerance) {
    std::vector<Polygon> moved = lines;
    const Ends ends(moved, tolerance.same);
    const std::vector<bool> is_doubled = find_doubled(moved, ends, tolerance.same);
    JoinedLines joined;
    for (std::size_t line = 0; line < moved.size(); ++line) {
        if (is_doubled[line]) {
            ++joined.doubled;
            continue;
        }
        joined.lines.push_back(std::move(moved[line]));
        joined.given.push_back(line);
    }
    put_ends_on_lines(joined, ends, tolerance.same);
    close_gaps(joined, ends, tolerance.gap);
    return joined;
}

DistinctCurves distinct_curves(std::vector<Polygon> curves, double same) {
    struct Measured {
        Point2 low, high;  // corners of the box around the curve
        double area;
        double around;
    };
    const auto is_same = [&](const Measured& a, const Measured& b) {
        return distance(a.low, b.low) <= same && distance(a.high, b.high) <= same &&
               std::abs(a.area - b.area) <= same * a.around;
    };
    geometry::PointGrid corners(same);
    std::vector<Measured> measured;
    DistinctCurves distinct;
    for (Polygon& curve : curves) {
        const geometry::Box box = geometry::box_of(curve);
        const Measured here{{box.xmin, box.ymin},
                            {box.xmax, box.ymax},
                            std::abs(geometry::signed_area(curve)),
                            perimeter(curve)};
        const bool is_doubled = corners.any_around(here.low, [&](std::size_t other) {
            return is_same(measured[other], here) &&
                   lie_on_each_other(distinct.curves[other], curve, Form::Closed, same);
        });
        if (is_doubled) {
            ++distinct.doubled;
            continue;
        }
        corners.add(here.low);
        measured.push_back(here);
        distinct.curves.push_back(std::move(curve));
    }
    return distinct;
}

}  // namespace fretwork::outlines::detail
