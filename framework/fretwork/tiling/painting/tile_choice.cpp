// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/quantity.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/geometry/winding.hpp>
#include <fretwork/tiling/painting/tile_choice.hpp>

#include <algorithm>
#include <set>

namespace fretwork::tiling {
namespace {

using geometry::Point2;

template <class Test>
std::vector<TileIndex> tiles_where(const Tessellation& tessellation, const Test& test) {
    std::vector<TileIndex> chosen;
    const auto centers = tile_centers(tessellation);
    for (std::size_t t = 0; t < centers.size(); ++t) {
        if (test(centers[t])) chosen.emplace_back(t);
    }
    return chosen;
}

std::size_t parse_tile(std::string_view text, std::size_t count) {
    const auto number = base::read_number<std::size_t>(text);
    if (number && *number < count) return *number;
    throw base::InputError("'" + std::string(text) + "' is not a tile: there are 0 to " +
                           std::to_string(count - 1) + ", and ranges such as 3-7");
}

}  // namespace

geometry::Box bounding_box(const Tessellation& tessellation) {
    if (tessellation.vertices.empty()) return {};
    return geometry::box_of(tessellation.vertices);
}

base::IndexVector<TileIndex, Point2> tile_centers(const Tessellation& tessellation) {
    base::IndexVector<TileIndex, Point2> centers;
    for (const TileIndex tile : tessellation.tiles.indices())
        centers.push_back(geometry::centroid(tile_polygon(tessellation, tile)));
    return centers;
}

std::vector<TileIndex> parse_tiles(std::string_view text, const Tessellation& tessellation) {
    std::set<std::size_t> chosen;
    const std::size_t count = tessellation.tiles.size();
    for (const std::string& part : base::split(text, ',')) {
        const auto ends = part.starts_with('-') ? std::vector{part} : base::split(part, '-');
        const std::size_t first = parse_tile(ends.size() > 2 ? part : ends.front(), count);
        const std::size_t last = parse_tile(ends.back(), count);
        if (last < first) throw base::InputError("'" + part + "' is a range that runs backwards");
        for (std::size_t tile = first; tile <= last; ++tile) chosen.insert(tile);
    }
    return {chosen.begin(), chosen.end()};
}

std::vector<TileIndex> tiles_in(const geometry::Box& box, const Tessellation& tessellation) {
    return tiles_where(tessellation, [&](Point2 center) {
        return center.x >= box.xmin && center.x <= box.xmax && center.y >= box.ymin && center.y <= box.ymax;
    });
}

std::vector<TileIndex> tiles_in(const geometry::Circle& circle, const Tessellation& tessellation) {
    return tiles_where(tessellation, [&](Point2 center) { return circle.contains(center); });
}

std::vector<TileIndex> tiles_in(const geometry::Polygon& polygon, const Tessellation& tessellation) {
    return tiles_where(tessellation,
                       [&](Point2 center) { return geometry::winding_number(polygon, center) != 0; });
}

}  // namespace fretwork::tiling
