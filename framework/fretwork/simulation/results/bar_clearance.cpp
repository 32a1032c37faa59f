// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/geometry/box_grid.hpp>
#include <fretwork/geometry/plane.hpp>
#include <fretwork/simulation/results/bar_clearance.hpp>
#include <fretwork/simulation/results/surface_beams.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <set>

namespace fretwork::simulation {
namespace {

using geometry::Point2;
using geometry::Segment;

double distance(const Point2& point, const Segment& segment) {
    return geometry::distance(geometry::nearest_on_segment(segment[0], segment[1], point), point);
}

double distance(const Segment& a, const Segment& b) {
    if (geometry::do_cross(a, b)) return 0.0;
    return std::min({distance(a[0], b), distance(a[1], b), distance(b[0], a), distance(b[1], a)});
}

/// The axes of the bars in the plane, and a search for close pairs.
class PlaneBars {
  public:
    explicit PlaneBars(const SurfaceBeams& beams) : beams_(beams) {
        for (std::size_t b = 0; b < beams.ends.size(); ++b) segments_.push_back(segment_of(b));
    }

    /// The pairs of bars with axes nearer than `reach`, and the gaps between bars of this width.
    [[nodiscard]] std::vector<CloseBars> close(double reach, double width,
                                               const base::Control& control) const {
        std::vector<geometry::Box> boxes;
        for (const Segment& segment : segments_) boxes.push_back(geometry::box_of(segment));
        const geometry::BoxGrid grid(boxes);
        std::vector<CloseBars> found;
        for (std::size_t bar = 0; bar < segments_.size(); ++bar) {
            control.check();
            for (const std::size_t other : grid.meeting(geometry::grown(boxes[bar], reach))) {
                if (other <= bar) continue;
                const double apart = distance_of(bar, other);
                if (apart < reach)
                    found.push_back({{bar, other}, {beams_.tiles[bar], beams_.tiles[other]}, apart - width});
            }
        }
        return found;
    }

  private:
    [[nodiscard]] Segment segment_of(std::size_t bar) const {
        const auto place = [&](mechanics::NodeIndex node) -> Point2 {
            return {beams_.nodes[node].x(), beams_.nodes[node].y()};
        };
        return {place(beams_.ends[bar][0]), place(beams_.ends[bar][1])};
    }

    /// The distance between the axes; if bars meet, between the far end of one and the other bar.
    [[nodiscard]] double distance_of(std::size_t bar, std::size_t other) const {
        for (std::size_t i = 0; i < 2; ++i) {
            for (std::size_t k = 0; k < 2; ++k) {
                if (beams_.ends[bar][i] != beams_.ends[other][k]) continue;
                return std::min(distance(segments_[bar][1 - i], segments_[other]),
                                distance(segments_[other][1 - k], segments_[bar]));
            }
        }
        return distance(segments_[bar], segments_[other]);
    }

    const SurfaceBeams& beams_;
    std::vector<Segment> segments_;
};

}  // namespace

std::vector<CloseBars> close_bars(const Surface& surface, double clearance, const base::Control& control) {
    if (!(clearance >= 0.0) || !std::isfinite(clearance))
        throw base::InputError("the clearance is " + base::format_number(clearance) +
                               ", where a finite length of 0 m or more is needed");
    const double width = mechanics::section_width(surface.setting.section);
    // Bars exactly as far apart as allowed are not reported, whatever the rounding.
    constexpr double kRounding = 1e-9;
    const SurfaceBeams beams = surface_beams(surface);
    control.check();
    return PlaneBars(beams).close((width + clearance) * (1.0 - kRounding), width, control);
}

std::string close_bars_text(const std::vector<CloseBars>& close) {
    if (close.empty()) return "";
    std::set<int> tiles;
    double least = close.front().gap;
    for (const CloseBars& pair : close) {
        for (const tiling::TileIndex tile : pair.tiles) tiles.insert(tile.value);
        least = std::min(least, pair.gap);
    }
    std::vector<std::string> names;
    constexpr std::size_t kMostNames = 8;
    for (const int tile : tiles)
        if (names.size() < kMostNames) names.push_back(std::to_string(tile));
    char gap[96];
    std::snprintf(gap, sizeof gap, least < 0 ? "overlap by up to %.2g mm" : "come as near as %.2g mm",
                  1e3 * std::abs(least));
    return base::counted(close.size(), "pair") + " of bars " + gap + ", in tile" +
           (tiles.size() == 1 ? " " : "s ") + base::join(names, ", ") +
           (tiles.size() > kMostNames ? ", .." : "");
}

}  // namespace fretwork::simulation
