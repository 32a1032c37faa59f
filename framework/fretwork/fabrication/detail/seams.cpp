// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/random.hpp>
#include <fretwork/fabrication/detail/seams.hpp>
#include <fretwork/geometry/plane.hpp>
#include <fretwork/geometry/point_grid.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace fretwork::fabrication::detail {
namespace {

using geometry::Box;
using geometry::Point2;

class SeamSearch {
  public:
    SeamSearch(const std::vector<Crossing>& crossings, const std::vector<Box>& boxes, const SeamRules& rules,
               std::vector<std::size_t> parts)
        : boxes_(boxes),
          rules_(rules),
          parts_(std::move(parts)),
          crossings_(crossings),
          crossings_of_tile_(boxes.size()) {
        for (std::size_t c = 0; c < crossings_.size(); ++c)
            for (const std::size_t tile : crossings_[c].tiles) crossings_of_tile_[tile].push_back(c);
    }

    /// The parts in which every connector has room; none: not found.
    std::optional<std::vector<std::size_t>> run() {
        std::vector<std::size_t> crowded = find_crowded();
        const std::size_t moves = kMoves + kMovesPerTile * boxes_.size();
        for (std::size_t move = 0; move < moves && !crowded.empty(); ++move) {
            if (move % kCheckEvery == 0) rules_.control.check();
            const double temperature =
                kHot * std::pow(kCold / kHot, static_cast<double>(move) / static_cast<double>(moves));
            if (try_move(crowded[random_.below(crowded.size())], temperature)) crowded = find_crowded();
        }
        if (!crowded.empty()) return std::nullopt;
        return parts_;
    }

  private:
    [[nodiscard]] bool is_connector(std::size_t crossing) const {
        const auto& [a, b] = crossings_[crossing].tiles;
        return parts_[a] != parts_[b];
    }

    [[nodiscard]] std::vector<std::size_t> find_crowded() const {
        std::vector<std::size_t> crowded;
        for (std::size_t c = 0; c < crossings_.size(); ++c) {
            if (!is_connector(c)) continue;
            const auto meets = [&](std::size_t other) { return is_connector(other); };
            if (crossings_[c].is_tight || std::ranges::any_of(crossings_[c].close, meets))
                crowded.push_back(c);
        }
        return crowded;
    }

    /// The cost of the connectors around a tile: a large cost for each lack of room, and a small cost for
    /// each connector, so that seams stay short.
    [[nodiscard]] double cost_around(std::size_t tile) const {
        constexpr double kConnector = 0.1;
        double cost = 0.0;
        for (const std::size_t c : crossings_of_tile_[tile]) {
            if (!is_connector(c)) continue;
            cost += kConnector + (crossings_[c].is_tight ? 1.0 : 0.0);
            for (const std::size_t other : crossings_[c].close) {
                if (!is_connector(other)) continue;
                const auto& [a, b] = crossings_[other].tiles;
                cost += a == tile || b == tile ? 0.5 : 1.0;  // pairs at the tile are counted twice
            }
        }
        return cost;
    }

    [[nodiscard]] std::size_t other_tile(std::size_t crossing, std::size_t tile) const {
        const auto& [a, b] = crossings_[crossing].tiles;
        return a == tile ? b : a;
    }
    std::size_t random_neighbour(std::size_t tile) {
        const auto& around = crossings_of_tile_[tile];
        return other_tile(around[random_.below(around.size())], tile);
    }

    /// Gives a tile at or beside a crossing to the part of one of its neighbours, if that is allowed and does
    /// not cost too much.
    bool try_move(std::size_t crossing, double temperature) {
        constexpr double kBeside = 0.4;
        std::size_t tile = crossings_[crossing].tiles[random_.below(2)];
        if (random_.share() < kBeside) tile = random_neighbour(tile);
        const std::size_t from = parts_[tile];
        const std::size_t to = parts_[random_neighbour(tile)];
        if (to == from || !fits_with(to, tile) || !stays_connected(from, tile)) return false;
        const double before = cost_around(tile);
        parts_[tile] = to;
        const double more = cost_around(tile) - before;
        if (more <= 0.0 || random_.share() < std::exp(-more / temperature)) return true;
        parts_[tile] = from;
        return false;
    }

    [[nodiscard]] bool fits_with(std::size_t part, std::size_t tile) const {
        Box box = boxes_[tile];
        for (std::size_t t = 0; t < parts_.size(); ++t)
            if (parts_[t] == part) box = geometry::united(box, boxes_[t]);
        return rules_.fits(box);
    }

    /// True if a part without this tile is connected and not empty.
    [[nodiscard]] bool stays_connected(std::size_t part, std::size_t without) const {
        std::vector<char> is_open(parts_.size(), 0);
        std::size_t left = 0;
        std::vector<std::size_t> next;
        for (std::size_t t = 0; t < parts_.size(); ++t) {
            if (parts_[t] != part || t == without) continue;
            if (++left == 1)
                next.push_back(t);
            else
                is_open[t] = 1;
        }
        if (left == 0) return false;
        for (std::size_t i = 0; i < next.size(); ++i) {
            for (const std::size_t c : crossings_of_tile_[next[i]]) {
                const std::size_t beside = other_tile(c, next[i]);
                if (std::exchange(is_open[beside], char{0}) != 0) next.push_back(beside);
            }
        }
        return next.size() == left;
    }

    static constexpr std::size_t kMoves = 4000;
    static constexpr std::size_t kMovesPerTile = 40;
    static constexpr std::size_t kCheckEvery = 64;
    static constexpr double kHot = 0.6;  // in costs of a lack of room
    static constexpr double kCold = 0.03;

    const std::vector<Box>& boxes_;
    const SeamRules& rules_;
    std::vector<std::size_t> parts_;
    const std::vector<Crossing>& crossings_;
    std::vector<std::vector<std::size_t>> crossings_of_tile_;
    base::SplitMix64 random_{1};
};

}  // namespace

std::vector<Crossing> crossings_of(const tiling::Tessellation& tessellation,
                                   std::span<const tiling::SharedSide> sides, double room) {
    std::vector<Crossing> crossings;
    for (const tiling::SharedSide& side : sides) {
        const std::size_t first = side.tiles[0];
        const std::size_t second = side.tiles[1];
        for (const tiling::InterfaceIndex node : side.nodes) {
            const Point2& place = tessellation.interface_nodes[node];
            const double end = std::min(distance(place, tessellation.vertices[side.from]),
                                        distance(place, tessellation.vertices[side.to]));
            crossings.push_back({{first, second}, place, end <= room, {}});
        }
    }
    geometry::PointGrid before(2.02 * room);  // the rounding of distances loses none
    for (std::size_t i = 0; i < crossings.size(); ++i) {
        std::vector<std::size_t>& close = crossings[i].close;
        before.visit_around(crossings[i].place, [&](std::size_t j) {
            if (0.5 * distance(crossings[i].place, crossings[j].place) <= room) close.push_back(j);
        });
        std::ranges::sort(close);  // costs are summed in this order
        for (const std::size_t j : close) crossings[j].close.push_back(i);
        before.add(crossings[i].place);
    }
    return crossings;
}

bool make_room(const std::vector<Crossing>& crossings, const std::vector<Box>& boxes, const SeamRules& rules,
               std::vector<std::size_t>& parts) {
    auto found = SeamSearch(crossings, boxes, rules, parts).run();
    if (!found) return false;
    parts = std::move(*found);
    return true;
}

}  // namespace fretwork::fabrication::detail
