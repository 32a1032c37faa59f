// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/geometry/plane.hpp>
#include <fretwork/tiling/remeshing/closed_curve.hpp>

#include <algorithm>
#include <iterator>

namespace fretwork::tiling::detail {

using geometry::Point2;
using geometry::Polygon;

ClosedCurve::ClosedCurve(Polygon points) : points_(std::move(points)), starts_{0.0} {
    for (std::size_t i = 0; i < points_.size(); ++i) {
        starts_.push_back(starts_.back() + distance(points_[i], points_[(i + 1) % points_.size()]));
    }
}

std::size_t ClosedCurve::side_of(double place) const {
    const auto after = std::upper_bound(starts_.begin() + 1, starts_.end() - 1, place);
    return after - starts_.begin() - 1;
}

Point2 ClosedCurve::at(double place) const {
    const double rest = place - length() * std::floor(place / length());
    const std::size_t i = side_of(rest);
    const double share = (rest - starts_[i]) / (starts_[i + 1] - starts_[i]);
    return between(points_[i], points_[(i + 1) % points_.size()], std::clamp(share, 0.0, 1.0));
}

double ClosedCurve::way(double from, double to) const {
    const double apart = to - from;
    return apart - length() * std::floor(apart / length());
}

Polygon ClosedCurve::stretch(double from, double to) const {
    Polygon points{at(from)};
    const double turns = std::floor(from / length());
    double base = turns * length();
    std::size_t i = side_of(from - base) + 1;
    for (;; ++i) {
        if (i == points_.size()) {
            i = 0;
            base += length();
        }
        if (base + starts_[i] >= to) break;
        if (base + starts_[i] > from) points.push_back(points_[i]);
    }
    points.push_back(at(to));
    return points;
}

double ClosedCurve::nearest_between(double from, double to, Point2 point) const {
    const Polygon points = stretch(from, to);
    double best = from;
    double best_distance = distance(points.front(), point);
    double along = from;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        const double side = distance(points[i], points[i + 1]);
        if (side <= 0) continue;
        const Point2 candidate = nearest_on_segment(points[i], points[i + 1], point);
        if (const double d = distance(candidate, point); d < best_distance) {
            best = along + distance(points[i], candidate);
            best_distance = d;
        }
        along += side;
    }
    return std::min(best, to);
}

double ClosedCurve::turn_at(double place, double reach) const {
    const Point2 here = at(place);
    return std::abs(turn(here - at(place - reach), at(place + reach) - here));
}

bool ClosedCurve::has_place_within(const std::set<double>& places, double place, double reach) const {
    if (places.empty()) return false;
    const auto is_near = [&](double other) {
        const double apart = std::abs(other - place);
        return std::min(apart, length() - apart) < reach;
    };
    const auto after = places.lower_bound(place);
    return (after != places.end() && is_near(*after)) ||
           (after != places.begin() && is_near(*std::prev(after))) || is_near(*places.begin()) ||
           is_near(*places.rbegin());
}

std::vector<double> ClosedCurve::corners(const std::function<double(Point2)>& reach,
                                         double smallest_turn) const {
    struct Candidate {
        double place;
        double turn;
        double reach;
    };
    std::vector<Candidate> candidates;
    for (std::size_t i = 0; i < points_.size(); ++i) {
        const double here = reach(points_[i]);
        const double turned = turn_at(starts_[i], here);
        if (turned > smallest_turn) candidates.push_back({starts_[i], turned, here});
    }
    // The sharpest corners first. Differences of the size of rounding do not change the order.
    std::stable_sort(candidates.begin(), candidates.end(),
                     [](const Candidate& a, const Candidate& b) { return a.turn > b.turn + 1e-9; });
    std::set<double> places;
    for (const Candidate& candidate : candidates) {
        if (!has_place_within(places, candidate.place, 2 * candidate.reach)) places.insert(candidate.place);
    }
    return {places.begin(), places.end()};
}

}  // namespace fretwork::tiling::detail
