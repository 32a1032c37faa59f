// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/geometry/plane.hpp>
#include <fretwork/tiling/remeshing/inside.hpp>

#include <algorithm>

namespace fretwork::tiling::detail {

using geometry::Point2;

InsideTest::InsideTest(const Rim& rim, double largest_margin, const base::Control& control) : rim_(rim) {
    Point2 low = rim.points.front().place;
    Point2 high = low;
    for (const RimPoint& point : rim.points) {
        low = {std::min(low.x, point.place.x), std::min(low.y, point.place.y)};
        high = {std::max(high.x, point.place.x), std::max(high.y, point.place.y)};
    }
    is_wide_ = high.x - low.x > high.y - low.y;
    low_ = along(low);
    sides_.resize(rim.points.size());
    band_ = (along(high) - low_) / static_cast<double>(sides_.size());
    for (std::size_t i = 0; i < rim.points.size(); ++i) {
        control.check();
        const double from = along(rim.points[i].place);
        const double to = along(rim.points[rim.next[i]].place);
        const std::size_t last = band_of(std::max(from, to) + largest_margin);
        for (std::size_t band = band_of(std::min(from, to) - largest_margin); band <= last; ++band)
            sides_[band].push_back(i);
    }
}

std::size_t InsideTest::band_of(double place) const {
    const double band = (place - low_) / band_;
    return static_cast<std::size_t>(std::clamp(band, 0.0, static_cast<double>(sides_.size() - 1)));
}

/// True if the ray from the point along its band crosses the side.
bool InsideTest::is_crossed(Point2 from, Point2 to, Point2 point) const {
    if ((along(from) > along(point)) == (along(to) > along(point))) return false;
    const bool is_left = cross(to - from, point - from) > 0;
    return is_wide_ ? is_left == (from.x > to.x) : is_left == (to.y > from.y);
}

bool InsideTest::operator()(Point2 point, double margin) const {
    bool inside = false;
    for (const std::size_t i : sides_[band_of(along(point))]) {
        const Point2 from = rim_.points[i].place;
        const Point2 to = rim_.points[rim_.next[i]].place;
        if (margin > 0 && distance(nearest_on_segment(from, to, point), point) < margin) return false;
        if (is_crossed(from, to, point)) inside = !inside;
    }
    return inside;
}

}  // namespace fretwork::tiling::detail
