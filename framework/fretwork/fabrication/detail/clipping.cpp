// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/fabrication/detail/clipping.hpp>
#include <fretwork/geometry/plane.hpp>

#include <algorithm>
#include <polyclipping/clipper.hpp>

namespace fretwork::fabrication::detail {
namespace {

using geometry::Box;
using geometry::Point2;

using ClipperLib::IntPoint;
using ClipperLib::Path;
using ClipperLib::Paths;
using geometry::Polygon;

constexpr double kPerMetre = 1e9;  ///< grid points
/// Smaller areas come only from rounding to the grid, between corners that should be one.
constexpr double kLeastArea = 1e-12;  // m2
/// Corners nearer to each other than kLeastStep are merged. Corners nearer to a straight line than
/// kLeastDeviation are removed.
constexpr double kLeastStep = 2e-8;       // m
constexpr double kLeastDeviation = 4e-9;  // m

/// Converts between metres and grid points around the middle of a box. The numbers stay small, because
/// Clipper is faster with numbers below 2^30.
class Grid {
  public:
    /// Throws GeometryError if the box is larger than Clipper's whole numbers reach.
    explicit Grid(const Box& box)
        : x_(std::round(box.middle().x * kPerMetre)), y_(std::round(box.middle().y * kPerMetre)) {
        constexpr double kLargest = 8e9;  // m; from the middle, 4e18 of 4.6e18 grid points
        const double size = std::max(box.width(), box.height());
        if (!(size <= kLargest))
            throw base::GeometryError("outlines are " + base::format_number(size, 3) +
                                      " m wide, where at most 8e+09 m can be cut or printed");
    }
    [[nodiscard]] Path path(const Polygon& polygon) const {
        Path path;
        path.reserve(polygon.size());
        for (const Point2& point : polygon)
            path.emplace_back(std::llround(point.x * kPerMetre - x_), std::llround(point.y * kPerMetre - y_));
        return path;
    }
    [[nodiscard]] Polygon polygon(const Path& path) const {
        Polygon polygon;
        polygon.reserve(path.size());
        for (const IntPoint& point : path)
            polygon.push_back({(static_cast<double>(point.X) + x_) / kPerMetre,
                               (static_cast<double>(point.Y) + y_) / kPerMetre});
        return polygon;
    }

  private:
    double x_;
    double y_;
};

Box box_of_all(std::span<const Polygon> polygons, Box box) {
    for (const Polygon& polygon : polygons) box = geometry::united(box, box_of(polygon));
    return box;
}

Paths counterclockwise(std::span<const Polygon> polygons, const Grid& grid) {
    Paths paths;
    for (const Polygon& polygon : polygons) {
        Path& path = paths.emplace_back(grid.path(polygon));
        if (!ClipperLib::Orientation(path)) ClipperLib::ReversePath(path);
    }
    return paths;
}

Paths as_they_are(std::span<const Polygon> polygons, const Grid& grid) {
    Paths paths;
    for (const Polygon& polygon : polygons) paths.push_back(grid.path(polygon));
    return paths;
}

bool is_corner(const Point2& before, const Point2& point, const Point2& after) {
    if (distance(before, point) < kLeastStep) return false;
    const double base = distance(before, after);
    if (base < kLeastStep) return false;
    const bool straight_on = dot(point - before, after - point) > 0.0;
    return !straight_on || std::abs(cross(after - before, point - before)) / base > kLeastDeviation;
}

/// The polygon without redundant corners.
Polygon cleaned(const Polygon& polygon) {
    Polygon corners = polygon;
    for (bool changed = true; changed && corners.size() >= 3;) {
        Polygon kept;
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const Point2& before = kept.empty() ? corners.back() : kept.back();
            if (is_corner(before, corners[i], corners[(i + 1) % corners.size()])) kept.push_back(corners[i]);
        }
        changed = kept.size() < corners.size();
        corners = std::move(kept);
    }
    return corners.size() >= 3 ? corners : Polygon{};
}

std::vector<Polygon> polygons_of(const Paths& paths, const Grid& grid) {
    std::vector<Polygon> polygons;
    for (const Path& path : paths) {
        Polygon polygon = cleaned(grid.polygon(path));
        if (polygon.empty() || std::abs(geometry::signed_area(polygon)) < kLeastArea) continue;
        polygons.push_back(std::move(polygon));
    }
    return polygons;
}

struct Operands {
    Paths subject;
    Paths clip;
};

Paths execute(const Operands& operands, ClipperLib::ClipType type) {
    ClipperLib::Clipper clipper;
    clipper.StrictlySimple(true);
    clipper.AddPaths(operands.subject, ClipperLib::ptSubject, true);
    clipper.AddPaths(operands.clip, ClipperLib::ptClip, true);
    Paths result;
    clipper.Execute(type, result, ClipperLib::pftNonZero, ClipperLib::pftNonZero);
    return result;
}

std::vector<Polygon> combined(std::span<const Polygon> left, std::span<const Polygon> right,
                              ClipperLib::ClipType type) {
    const std::span<const Polygon> any = left.empty() ? right : left;
    if (any.empty()) return {};
    const Grid grid(
        box_of_all(right, box_of_all(left, geometry::box_of(std::span<const Point2>(any.front())))));
    return polygons_of(execute({as_they_are(left, grid), as_they_are(right, grid)}, type), grid);
}

/// Whether an edge is a chord of a circle, or part of one.
bool is_chord(const Disc& disc, const Point2& from, const Point2& to) {
    constexpr double kOnGrid = 3e-9;  // m
    const double sagitta = disc.radius * (1.0 - std::cos(0.5 * kChordAngle));
    const auto is_on = [&](const Point2& point) {
        const double gap = disc.radius - distance(disc.center, point);
        return gap > -kOnGrid && gap < sagitta + kOnGrid;
    };
    return distance(from, to) < disc.radius * kChordAngle + kOnGrid && is_on(from) && is_on(to) &&
           is_on(0.5 * (from + to));
}

/// For each edge the number of its circle, or -1.
std::vector<int> circles_of_edges(const Polygon& polygon, std::span<const Disc> discs) {
    std::vector<int> circles(polygon.size(), -1);
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        for (std::size_t d = 0; d < discs.size() && circles[i] < 0; ++d)
            if (is_chord(discs[d], polygon[i], polygon[(i + 1) % polygon.size()]))
                circles[i] = static_cast<int>(d);
    }
    return circles;
}

/// The angle that an edge subtends at the center of a circle, rad, counterclockwise positive.
double angle_at(const Point2& center, const Point2& from, const Point2& to) {
    return turn(from - center, to - center);
}

/// The place, next to `point`, where the line from `before` meets the circle. `point` is a little inside.
Point2 on_circle(const Disc& disc, const Point2& point, const Point2& before) {
    const Point2 along = unit(point - before);
    const double middle = dot(disc.center - point, along);
    const double off = cross(along, disc.center - point);
    const double half = std::sqrt(std::max(0.0, disc.radius * disc.radius - off * off));
    const double near = std::abs(middle - half) < std::abs(middle + half) ? middle - half : middle + half;
    const Point2 found = point + near * along;
    const double chord = disc.radius * kChordAngle;
    return distance(found, point) < chord ? found : disc.center + disc.radius * unit(point - disc.center);
}

/// Puts arcs in the place of a polygon's chords.
class ArcFinder {
  public:
    ArcFinder(const Polygon& polygon, std::span<const Disc> discs)
        : polygon_(polygon), discs_(discs), circles_(circles_of_edges(polygon, discs)) {}

    [[nodiscard]] Contour run() const {
        const std::size_t count = polygon_.size();
        std::size_t first = 0;  // where a new line or arc begins
        while (first < count && !begins(first)) ++first;
        if (first == count) return whole_circle();
        Contour contour;
        for (std::size_t k = 0; k < count; ++k) {
            const std::size_t i = (first + k) % count;
            if (circles_[i] < 0)
                contour.push_back({begins_or_ends_arc(i) ? end_of_arc(i) : polygon_[i], 0.0});
            if (circles_[i] >= 0 && begins(i)) add_arc(contour, i);
        }
        return contour;
    }

  private:
    [[nodiscard]] std::size_t after(std::size_t i) const { return (i + 1) % polygon_.size(); }
    [[nodiscard]] std::size_t before(std::size_t i) const {
        return (i + polygon_.size() - 1) % polygon_.size();
    }
    [[nodiscard]] const Disc& disc(std::size_t edge) const { return discs_[circles_[edge]]; }
    [[nodiscard]] bool begins(std::size_t i) const {
        return circles_[i] < 0 || circles_[i] != circles_[before(i)];
    }
    [[nodiscard]] bool begins_or_ends_arc(std::size_t i) const {
        return circles_[i] >= 0 || circles_[before(i)] >= 0;
    }

    /// The corner between an arc and its neighbour. It lies on the arc's circle and, if the neighbour is a
    /// line, also on that line.
    [[nodiscard]] Point2 end_of_arc(std::size_t i) const {
        const bool arc_before = circles_[before(i)] >= 0;
        const Disc& circle = disc(arc_before ? before(i) : i);
        if (arc_before && circles_[i] >= 0)  // two arcs
            return circle.center + circle.radius * unit(polygon_[i] - circle.center);
        return on_circle(circle, polygon_[i], polygon_[arc_before ? after(i) : before(i)]);
    }

    [[nodiscard]] Contour whole_circle() const {
        const Contour whole = circle(disc(0).center, disc(0).radius);
        return geometry::signed_area(polygon_) > 0.0 ? whole : reversed(whole);
    }

    void add_arc(Contour& contour, std::size_t first) const {
        constexpr double kLongestArc =
            4.0;  // rad; a longer one becomes two arcs, so that its bulge is accurate
        const Point2 center = disc(first).center;
        double sweep = 0.0;
        std::size_t last = first;
        for (; last == first || !begins(last); last = after(last))
            sweep += angle_at(center, polygon_[last], polygon_[after(last)]);
        const Point2 from = end_of_arc(first);
        const Point2 to = end_of_arc(last);
        sweep += angle_at(center, from, polygon_[first]) + angle_at(center, polygon_[last], to);
        if (std::abs(sweep) <= kLongestArc) {
            contour.push_back({from, std::tan(0.25 * sweep)});
            return;
        }
        const double middle = std::atan2(from.y - center.y, from.x - center.x) + 0.5 * sweep;
        contour.push_back({from, std::tan(0.125 * sweep)});
        contour.push_back(
            {center + disc(first).radius * geometry::direction(middle), std::tan(0.125 * sweep)});
    }

    const Polygon& polygon_;
    std::span<const Disc> discs_;
    std::vector<int> circles_;
};

}  // namespace

std::vector<Polygon> difference(const Polygon& whole, std::span<const Polygon> parts) {
    const Grid grid(box_of(whole));
    return polygons_of(execute({{grid.path(whole)}, counterclockwise(parts, grid)}, ClipperLib::ctDifference),
                       grid);
}

std::vector<Polygon> united(std::span<const Polygon> polygons) {
    if (polygons.empty()) return {};
    const Grid grid(box_of_all(polygons, box_of(polygons.front())));
    return polygons_of(execute({counterclockwise(polygons, grid), {}}, ClipperLib::ctUnion), grid);
}

std::vector<Polygon> merged(std::span<const Polygon> left, std::span<const Polygon> right) {
    return combined(left, right, ClipperLib::ctUnion);
}

std::vector<Polygon> without(std::span<const Polygon> whole, std::span<const Polygon> parts) {
    return combined(whole, parts, ClipperLib::ctDifference);
}

double least_width() {
    const double corner = 1.0 - std::cos(kChordAngle);  // its distance from that line, in radii
    return 2.0 * (2.0 * kLeastDeviation / corner);
}

Contour with_arcs(const Polygon& polygon, std::span<const Disc> discs) {
    return ArcFinder(polygon, discs).run();
}

}  // namespace fretwork::fabrication::detail
