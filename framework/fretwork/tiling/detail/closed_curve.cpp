// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/tiling/detail/closed_curve.hpp>
#include <fretwork/tiling/detail/plane.hpp>

#include <algorithm>
#include <iterator>
#include <limits>

namespace fretwork::tiling::detail {
namespace {

constexpr std::size_t kSidesPerStretch = 16;

}  // namespace
ClosedCurve::ClosedCurve(Polygon points) : points_(std::move(points)), starts_{0.0} {
    for (std::size_t i = 0; i < points_.size(); ++i) {
        starts_.push_back(starts_.back() + distance(points_[i], points_[(i + 1) % points_.size()]));
    }
    for (std::size_t first = 0; first < points_.size(); first += kSidesPerStretch) {
        const std::size_t last = std::min(first + kSidesPerStretch, points_.size());
        const double half = 0.5 * (starts_[last] - starts_[first]);
        stretches_.push_back({at(starts_[first] + half), half, first, last});
    }
}

Point2 ClosedCurve::at(double place) const {
    const double rest = place - length() * std::floor(place / length());
    const auto after = std::upper_bound(starts_.begin() + 1, starts_.end() - 1, rest);
    const auto i = static_cast<std::size_t>(after - starts_.begin() - 1);
    const double share = (rest - starts_[i]) / (starts_[i + 1] - starts_[i]);
    return between(points_[i], points_[(i + 1) % points_.size()], std::clamp(share, 0.0, 1.0));
}

Point2 ClosedCurve::nearest(Point2 point) const {
    // The middles are points of the curve, so the nearest one bounds the distance, and few stretches are
    // left.
    double reach = std::numeric_limits<double>::infinity();
    for (const Stretch& stretch : stretches_) reach = std::min(reach, distance(stretch.middle, point));
    Point2 best = points_.front();
    double best_distance = std::numeric_limits<double>::infinity();
    for (const Stretch& stretch : stretches_) {
        if (distance(stretch.middle, point) - stretch.half_length > reach) continue;
        for (std::size_t i = stretch.first; i < stretch.last; ++i) {
            const Point2 candidate = nearest_on_side(points_[i], points_[(i + 1) % points_.size()], point);
            const double d = distance(candidate, point);
            if (d >= best_distance) continue;
            best = candidate;
            best_distance = d;
            reach = std::min(reach, d);
        }
    }
    return best;
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

std::vector<double> ClosedCurve::corners(double reach, double smallest_turn) const {
    struct Candidate {
        double place;
        double turn;
    };
    std::vector<Candidate> candidates;
    for (std::size_t i = 0; i < points_.size(); ++i) {
        const double turned = turn_at(starts_[i], reach);
        if (turned > smallest_turn) candidates.push_back({starts_[i], turned});
    }
    // The sharpest first; a tiny difference (rounding) does not decide between equals.
    std::stable_sort(candidates.begin(), candidates.end(),
                     [](const Candidate& a, const Candidate& b) { return a.turn > b.turn + 1e-9; });
    std::set<double> places;
    for (const Candidate& candidate : candidates) {
        if (!has_place_within(places, candidate.place, 2 * reach)) places.insert(candidate.place);
    }
    return {places.begin(), places.end()};
}

}  // namespace fretwork::tiling::detail
