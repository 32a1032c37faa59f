// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/geometry/internal/place_limits.hpp>
#include <fretwork/geometry/nearly_convex.hpp>
#include <fretwork/geometry/plane.hpp>
#include <fretwork/pattern/pattern.hpp>
#include <fretwork/tiling/tessellation.hpp>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace fretwork::tiling {
namespace {

using geometry::Point2;

/// The largest distance of an interface node from its place, as a share of the side, to allow for rounding of
/// coordinates.
constexpr double kPlaceTolerance = 1e-6;

class Checker {
  public:
    Checker(const Tessellation& tessellation, const pattern::NodeLayout& layout)
        : tessellation_(tessellation), layout_(layout) {
        for (const pattern::Rational& place : layout.description().interface)
            places_.push_back(place.to_double());
    }

    void run() {
        if (tessellation_.layout != layout_.name())
            throw base::InputError("the tessellation is for the node layout '" + tessellation_.layout +
                                   "', and not for '" + layout_.name() + "'");
        if (tessellation_.tiles.empty()) throw base::InputError("the tessellation has no tiles");
        check_places(tessellation_.vertices, "vertex");
        check_places(tessellation_.interface_nodes, "interface node");
        check_patterns();
        for (std::size_t t = 0; t < tessellation_.tiles.size(); ++t) {
            check_indices(t);
            check_shape(t);
            check_sides(t);
        }
        check_all_used();
    }

  private:
    /// A side in the direction of its tile.
    struct Side {
        std::size_t tile;
        std::vector<InterfaceIndex> nodes;
    };

    [[noreturn]] static void fail(std::size_t tile, const std::string& message) {
        throw base::InputError("tile " + std::to_string(tile) + " " + message);
    }
    [[nodiscard]] Point2 vertex(VertexIndex index) const { return tessellation_.vertices[index]; }

    static void check_places(const std::vector<Point2>& places, const std::string& what) {
        for (std::size_t i = 0; i < places.size(); ++i) {
            if (!geometry::is_within_limits(places[i]))
                throw base::InputError(
                    geometry::beyond_limits_text(what + " " + std::to_string(i), places[i]));
        }
    }

    void check_patterns() const {
        std::map<std::string, std::size_t> first_uses;
        for (std::size_t i = 0; i < tessellation_.patterns.size(); ++i) {
            const pattern::NamedPattern& pattern = tessellation_.patterns[i];
            if (pattern::parse_named_pattern(layout_, pattern.id) != pattern)
                throw base::InputError("pattern " + std::to_string(i) + " is not the one that its id '" +
                                       pattern.id + "' names");
            const auto [entry, is_new] = first_uses.try_emplace(pattern.id, i);
            if (!is_new)
                throw base::InputError("pattern " + std::to_string(i) + " is pattern " +
                                       std::to_string(entry->second) + " again: '" + entry->first + "'");
        }
    }

    void check_indices(std::size_t t) const {
        const Tile& tile = tessellation_.tiles[t];
        const auto check = [&](int index, std::size_t count, const std::string& what) {
            if (index < 0 || std::cmp_greater_equal(index, count))
                fail(t, "names the " + what + " " + std::to_string(index) + ", and there are " +
                            std::to_string(count));
        };
        if (tile.vertices.size() < 3)
            fail(t, "has " + std::to_string(tile.vertices.size()) + " vertices, where at least 3 are needed");
        const std::size_t wanted = tile.vertices.size() * places_.size();
        if (tile.interface_nodes.size() != wanted)
            fail(t, "has " + std::to_string(tile.interface_nodes.size()) + " interface nodes, where " +
                        std::to_string(wanted) + " are needed");
        for (const VertexIndex index : tile.vertices) check(index, tessellation_.vertices.size(), "vertex");
        for (const InterfaceIndex index : tile.interface_nodes)
            check(index, tessellation_.interface_nodes.size(), "interface node");
        if (tile.pattern != -1) check(tile.pattern, tessellation_.patterns.size(), "pattern");
    }

    void check_shape(std::size_t t) const {
        const geometry::Polygon polygon = tile_polygon(tessellation_, TileIndex(t));
        if (!geometry::is_nearly_convex(polygon))
            throw base::GeometryError("tile " + std::to_string(t) + " is not convex and counterclockwise" +
                                      geometry::inward_bend_text(polygon));
    }

    void check_sides(std::size_t t) {
        const Tile& tile = tessellation_.tiles[t];
        for (std::size_t i = 0; i < tile.vertices.size(); ++i) {
            const VertexIndex from = tile.vertices[i];
            const VertexIndex to = tile.vertices[(i + 1) % tile.vertices.size()];
            const auto first = tile.interface_nodes.begin() + i * places_.size();
            Side side{t, {first, first + places_.size()}};
            check_on_side(side, vertex(from), vertex(to));
            check_neighbor(side, from, to);
            sides_[{from, to}] = std::move(side);
        }
    }

    void check_on_side(const Side& side, Point2 from, Point2 to) const {
        for (std::size_t k = 0; k < places_.size(); ++k) {
            const Point2 wanted = between(from, to, places_[k]);
            const Point2 there = tessellation_.interface_nodes[side.nodes[k]];
            if (distance(wanted, there) > kPlaceTolerance * distance(from, to))
                fail(side.tile, "has the interface node " + std::to_string(side.nodes[k].value) +
                                    " away from its place on the side, which is (" +
                                    base::format_number(wanted.x) + ", " + base::format_number(wanted.y) +
                                    ")");
        }
    }

    /// Check that the neighbour at a side has the same vertices and interface nodes in the opposite
    /// direction. At a side without a neighbour, the interface nodes must be new.
    void check_neighbor(const Side& side, VertexIndex from, VertexIndex to) {
        if (const auto same = sides_.find({from, to}); same != sides_.end())
            fail(side.tile, "runs along one of its sides in the same direction as tile " +
                                std::to_string(same->second.tile));
        const auto other = sides_.find({to, from});
        if (other == sides_.end()) {
            for (const InterfaceIndex node : side.nodes) {
                if (!used_.insert(node).second)
                    fail(side.tile, "has the interface node " + std::to_string(node.value) +
                                        ", which is on another side");
            }
        } else if (!std::equal(side.nodes.begin(), side.nodes.end(), other->second.nodes.rbegin())) {
            fail(side.tile, "and tile " + std::to_string(other->second.tile) +
                                " share a side and do not agree about its interface nodes");
        }
    }

    void check_all_used() const {
        for (std::size_t node = 0; node < tessellation_.interface_nodes.size(); ++node) {
            if (!used_.contains(InterfaceIndex(node)))
                throw base::InputError("interface node " + std::to_string(node) + " is on no tile");
        }
        std::vector<bool> has_tile(tessellation_.vertices.size(), false);
        for (const auto& [ends, side] : sides_) has_tile[ends.first.value] = true;
        const auto unused = std::find(has_tile.begin(), has_tile.end(), false);
        if (unused != has_tile.end())
            throw base::InputError("vertex " + std::to_string(unused - has_tile.begin()) + " is on no tile");
    }

    const Tessellation& tessellation_;
    const pattern::NodeLayout& layout_;
    std::vector<double> places_;  // places of the interface nodes, as shares of a side
    std::map<std::pair<VertexIndex, VertexIndex>, Side> sides_;
    std::set<InterfaceIndex> used_;
};

}  // namespace

void validate(const Tessellation& tessellation, const pattern::NodeLayout& layout) {
    Checker(tessellation, layout).run();
}

}  // namespace fretwork::tiling
