// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/geometry/plane.hpp>
#include <fretwork/outlines/outline_check.hpp>
#include <fretwork/tiling/remeshing/rim.hpp>

#include <algorithm>
#include <numbers>

namespace fretwork::tiling::detail {
namespace {

using geometry::Point2;
using geometry::Polygon;

constexpr double kCornerReach = 0.25;  // share of the spacing
constexpr double kCornerTurn =
    40.0 * std::numbers::pi / 180;  // corners of a pentagon count as corners; an octagon's corners only just
constexpr double kMeasuring =
    0.25;  // share of the spacing; steps in which the spacing is measured along a curve

struct Place {
    double along;
    bool is_corner;
};

class Sampler {
  public:
    Sampler(const ClosedCurve& curve, const Spacing& spacing) : curve_(curve), spacing_(spacing) {}

    std::vector<Place> run() {
        const auto reach = [&](Point2 point) { return kCornerReach * spacing_.at(point); };
        const std::vector<double> corners = curve_.corners(reach, kCornerTurn);
        if (corners.empty()) fill(0, curve_.length(), 3);
        const int fewest = corners.size() == 1 ? 3 : corners.size() == 2 ? 2 : 1;
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const std::size_t first = places_.size();
            const double to = i + 1 < corners.size() ? corners[i + 1] : corners.front() + curve_.length();
            fill(corners[i], to, fewest);
            places_[first].is_corner = true;
        }
        return std::move(places_);
    }

  private:
    /// Add places from one corner to the next, the first included: at least `fewest` places, with equal
    /// distances in units of the local spacing.
    void fill(double from, double to, int fewest) {
        const std::vector<double> spacings = spacings_along(from, to);
        const int count = std::max(fewest, static_cast<int>(std::lround(spacings.back())));
        const double steps = static_cast<double>(spacings.size() - 1);
        std::size_t step = 1;
        for (int i = 0; i < count; ++i) {
            const double wanted = spacings.back() * i / count;
            while (spacings[step] < wanted) ++step;
            const double share = (wanted - spacings[step - 1]) / (spacings[step] - spacings[step - 1]);
            const double along = (static_cast<double>(step - 1) + share) / steps;
            places_.push_back({from + (to - from) * along, false});
        }
    }
    /// The number of spacings from `from` to each of the even steps up to `to`.
    [[nodiscard]] std::vector<double> spacings_along(double from, double to) const {
        double least = spacing_.largest();
        if (!spacing_.field.is_uniform()) {
            for (double along = from; along < to; along += kMeasuring * spacing_.at(curve_.at(along)))
                least = std::min(least, spacing_.at(curve_.at(along)));
        }
        const auto steps = std::max(1.0, std::ceil((to - from) / (kMeasuring * least)));
        std::vector<double> spacings{0.0};
        const double step = (to - from) / steps;
        while (spacings.size() <= static_cast<std::size_t>(steps)) {
            const double middle = from + (static_cast<double>(spacings.size()) - 0.5) * step;
            spacings.push_back(spacings.back() + step / spacing_.at(curve_.at(middle)));
        }
        return spacings;
    }

    const ClosedCurve& curve_;
    const Spacing& spacing_;
    std::vector<Place> places_;
};

}  // namespace

Rim sample_rim(const outlines::Outline& outline, const Spacing& spacing, const base::Control& control) {
    Rim rim;
    rim.curves.emplace_back(outline.boundary);
    for (const Polygon& hole : outline.holes) rim.curves.emplace_back(hole);
    for (std::size_t loop = 0; loop < rim.curves.size(); ++loop) {
        control.check();
        const PointIndex first(rim.points.size());
        const ClosedCurve& curve = rim.curves[loop];
        for (const Place& place : Sampler(curve, spacing).run()) {
            const double along = std::fmod(place.along, curve.length());
            rim.points.push_back({curve.at(along), LoopIndex(loop), along, place.is_corner});
            rim.next.emplace_back(rim.points.size());
        }
        rim.next.back() = first;
    }
    return rim;
}

std::vector<Point2> rim_crossings(const Rim& rim, const base::Control& control) {
    base::IndexVector<LoopIndex, Polygon> loops(rim.curves.size());
    for (const RimPoint& point : rim.points) loops[point.loop].push_back(point.place);
    return outlines::places_of_crossings(loops, control);
}

}  // namespace fretwork::tiling::detail
