// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/geometry/plane.hpp>
#include <fretwork/outlines/dxf/dxf_curves.hpp>

#include <algorithm>

namespace fretwork::outlines::detail {
namespace {

using geometry::Point2;
using geometry::Polygon;

constexpr long kMostDegree = 30;
constexpr int kFirstPieces = 4;  // pieces of a knot span at the start, so that no inflection is overlooked
constexpr int kMostHalvings = 12;

struct Spline {
    std::size_t degree = 3;
    std::vector<double> knots{};
    std::vector<Point2> points{};   // in the drawing's units
    std::vector<double> weights{};  // one for each point

    /// De Boor's algorithm in homogeneous coordinates. `span`: knots[span] <= t <= knots[span + 1].
    [[nodiscard]] Point2 at(double t, std::size_t span) const {
        struct Weighted {
            Point2 place;
            double weight;
        };
        std::vector<Weighted> row(degree + 1);
        for (std::size_t j = 0; j <= degree; ++j) {
            const std::size_t i = span - degree + j;
            row[j] = {weights[i] * points[i], weights[i]};
        }
        for (std::size_t level = 1; level <= degree; ++level) {
            for (std::size_t j = degree; j >= level; --j) {
                const double from = knots[span - degree + j];
                const double to = knots[span + 1 + j - level];
                const double share = to > from ? (t - from) / (to - from) : 0;
                row[j] = {between(row[j - 1].place, row[j].place, share),
                          row[j - 1].weight + share * (row[j].weight - row[j - 1].weight)};
            }
        }
        return (1 / row[degree].weight) * row[degree].place;
    }
};

std::vector<double> numbers(const DxfFile& file, const DxfEntity& entity, int code) {
    std::vector<double> found;
    for (const DxfGroup& group : entity.groups)
        if (group.code == code) found.push_back(file.number(group));
    return found;
}

Spline read_spline(const DxfFile& file, const DxfEntity& entity) {
    const long degree = file.whole_or(entity, 71, 3);
    const std::vector<double> x = numbers(file, entity, 10);
    const std::vector<double> y = numbers(file, entity, 20);
    Spline spline{.knots = numbers(file, entity, 40), .weights = numbers(file, entity, 41)};
    if (degree < 1 || degree > kMostDegree)
        file.fail(entity.line, "SPLINE has the degree " + std::to_string(degree));
    spline.degree = degree;
    if (x.size() != y.size() || x.size() <= spline.degree ||
        spline.knots.size() != x.size() + spline.degree + 1)
        file.fail(entity.line,
                  "SPLINE of degree " + std::to_string(degree) + " has " + std::to_string(x.size()) +
                      " control points and " + std::to_string(spline.knots.size()) +
                      " knots, where there must be one more knot than points and degree together");
    if (!std::ranges::is_sorted(spline.knots)) file.fail(entity.line, "SPLINE has knots that do not ascend");
    for (std::size_t i = 0; i < x.size(); ++i) spline.points.push_back({x[i], y[i]});
    if (spline.weights.empty()) spline.weights.assign(x.size(), 1.0);
    const bool are_fit = spline.weights.size() == x.size() &&
                         std::ranges::all_of(spline.weights, [](double w) { return w > 0; });
    if (!are_fit) file.fail(entity.line, "SPLINE needs one weight above zero for each control point");
    return spline;
}

/// A stretch of the curve within one knot span.
struct Stretch {
    double from;
    double to;
    std::size_t span;
};

class SplinePen {
  public:
    SplinePen(const Spline& spline, const DxfFlattening& how) : spline_(spline), how_(how) {}

    void draw(const Stretch& stretch) {
        if (points_.empty()) points_.push_back(place(stretch.from, stretch.span));
        halve(stretch, kMostHalvings);
    }
    [[nodiscard]] Polygon taken() { return std::move(points_); }

  private:
    [[nodiscard]] Point2 place(double t, std::size_t span) const {
        return how_.to_metres(spline_.at(t, span));
    }

    void halve(const Stretch& stretch, int left) {
        if (points_.size() > how_.most) return;
        const Point2 from = points_.back();
        const Point2 to = place(stretch.to, stretch.span);
        const double middle = 0.5 * (stretch.from + stretch.to);
        if (left == 0 || is_straight(stretch, from, to)) return points_.push_back(to);
        halve({stretch.from, middle, stretch.span}, left - 1);
        halve({middle, stretch.to, stretch.span}, left - 1);
    }
    [[nodiscard]] bool is_straight(const Stretch& stretch, Point2 from, Point2 to) const {
        return std::ranges::all_of(std::array{0.25, 0.5, 0.75}, [&](double share) {
            const Point2 there = place(stretch.from + share * (stretch.to - stretch.from), stretch.span);
            const Point2 nearest = nearest_on_segment(from, to, there);
            return distance(there, nearest) <= how_.tolerance;
        });
    }

    const Spline& spline_;
    const DxfFlattening& how_;
    Polygon points_;
};

}  // namespace

Polygon draw_dxf_spline(const DxfFile& file, const DxfEntity& entity, const DxfFlattening& how) {
    const Spline spline = read_spline(file, entity);
    SplinePen pen(spline, how);
    for (std::size_t span = spline.degree; span < spline.points.size(); ++span) {
        const double from = spline.knots[span];
        const double step = (spline.knots[span + 1] - from) / kFirstPieces;
        if (!(step > 0)) continue;
        for (int i = 0; i < kFirstPieces; ++i) pen.draw({from + i * step, from + (i + 1) * step, span});
    }
    return pen.taken();
}

}  // namespace fretwork::outlines::detail
