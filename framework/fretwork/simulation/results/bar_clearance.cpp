// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/text.hpp>
#include <fretwork/simulation/results/bar_clearance.hpp>
#include <fretwork/simulation/results/surface_beams.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <set>
#include <utility>

namespace fretwork::simulation {
namespace {

using Place = Eigen::Vector2d;
using Segment = std::array<Place, 2>;

double distance(const Place& point, const Segment& segment) {
    const Place along = segment[1] - segment[0];
    const double share = std::clamp(along.dot(point - segment[0]) / along.squaredNorm(), 0.0, 1.0);
    return (segment[0] + share * along - point).norm();
}

double cross(const Place& a, const Place& b) {
    return a.x() * b.y() - a.y() * b.x();
}

bool do_cross(const Segment& a, const Segment& b) {
    const Place along_a = a[1] - a[0];
    const Place along_b = b[1] - b[0];
    const auto parts = [](const Place& along, const Place& from, const Segment& other) {
        return cross(along, other[0] - from) * cross(along, other[1] - from) < 0.0;
    };
    return parts(along_a, a[0], b) && parts(along_b, b[0], a);
}

double distance(const Segment& a, const Segment& b) {
    if (do_cross(a, b)) return 0.0;
    return std::min({distance(a[0], b), distance(a[1], b), distance(b[0], a), distance(b[1], a)});
}

/// Bars sorted into squares, so that only those near each other are compared.
class BarGrid {
  public:
    BarGrid(const SurfaceBeams& beams, double reach) : beams_(beams), reach_(reach) {
        for (std::size_t b = 0; b < beams.ends.size(); ++b) segments_.push_back(segment_of(b));
        for (const Segment& segment : segments_) side_ = std::max(side_, (segment[1] - segment[0]).norm());
        side_ += reach;
        for (std::size_t b = 0; b < segments_.size(); ++b) cells_[cell_of(b)].push_back(b);
    }

    std::vector<CloseBars> close(double width, const base::Control& control) const {
        std::vector<CloseBars> found;
        for (std::size_t b = 0; b < segments_.size(); ++b) {
            control.check();
            const auto [column, row] = cell_of(b);
            for (long dx = -1; dx <= 1; ++dx)
                for (long dy = -1; dy <= 1; ++dy) add_close(b, {column + dx, row + dy}, width, found);
        }
        return found;
    }

  private:
    using Cell = std::pair<long, long>;

    [[nodiscard]] Segment segment_of(std::size_t bar) const {
        const auto place = [&](mechanics::NodeIndex node) -> Place {
            return beams_.nodes[static_cast<std::size_t>(node)].head<2>();
        };
        return {place(beams_.ends[bar][0]), place(beams_.ends[bar][1])};
    }
    /// Two bars nearer than the reach have their middles at most one cell apart.
    [[nodiscard]] Cell cell_of(std::size_t bar) const {
        const Place middle = 0.5 * (segments_[bar][0] + segments_[bar][1]);
        return {std::lround(std::floor(middle.x() / side_)), std::lround(std::floor(middle.y() / side_))};
    }

    void add_close(std::size_t bar, const Cell& cell, double width, std::vector<CloseBars>& found) const {
        const auto bars = cells_.find(cell);
        if (bars == cells_.end()) return;
        for (const std::size_t other : bars->second) {
            if (other <= bar) continue;
            const double apart = distance_of(bar, other);
            if (apart < reach_)
                found.push_back({{bar, other}, {beams_.tiles[bar], beams_.tiles[other]}, apart - width});
        }
    }

    /// Between the axes; of bars that meet, between the far end of one and the other.
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
    double reach_;
    double side_ = 0.0;
    std::vector<Segment> segments_;
    std::map<Cell, std::vector<std::size_t>> cells_;
};

}  // namespace

std::vector<CloseBars> close_bars(const Surface& surface, double clearance, const base::Control& control) {
    const double width = mechanics::rectangle_width(surface.setting.section);
    // Bars exactly as far apart as they may be are not told, whatever rounding does to them.
    constexpr double kRounding = 1e-9;
    const SurfaceBeams beams = surface_beams(surface);
    return BarGrid(beams, (width + clearance) * (1.0 - kRounding)).close(width, control);
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
    return std::to_string(close.size()) + (close.size() == 1 ? " pair of bars" : " pairs of bars") + " " +
           gap + ", in tile" + (tiles.size() == 1 ? " " : "s ") + base::join(names, ", ") +
           (tiles.size() > kMostNames ? ", .." : "");
}

}  // namespace fretwork::simulation
