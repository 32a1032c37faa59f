// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/disjoint_sets.hpp>
#include <fretwork/base/error.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/fabrication/detail/parts.hpp>
#include <fretwork/fabrication/detail/seams.hpp>
#include <fretwork/geometry/plane.hpp>

#include <algorithm>
#include <iterator>
#include <map>
#include <numeric>
#include <optional>
#include <span>
#include <utility>

namespace fretwork::fabrication::detail {
namespace {

using geometry::Box;
using geometry::Point2;

constexpr double kRounding = 1e-9;  // m

bool fits(double width, double height, const Bed& bed) {
    const double across = bed.width - 2.0 * bed.margin + kRounding;
    const double up = bed.height - 2.0 * bed.margin + kRounding;
    return (width <= across && height <= up) || (height <= across && width <= up);
}

std::vector<Box> tile_boxes(const tiling::Tessellation& tessellation) {
    std::vector<Box> boxes;
    for (std::size_t t = 0; t < tessellation.tiles.size(); ++t) {
        const geometry::Polygon polygon = tiling::tile_polygon(tessellation, TileIndex(t));
        boxes.push_back(geometry::box_of(std::span<const Point2>(polygon)));
    }
    return boxes;
}

struct Cells {
    std::size_t columns = 1;
    std::size_t rows = 1;
};

std::vector<std::size_t> cells_of_tiles(const std::vector<Box>& boxes, const Box& whole, const Cells& cells) {
    std::vector<std::size_t> found;
    const auto index = [](double share, std::size_t count) {
        return std::min(count - 1, static_cast<std::size_t>(share * static_cast<double>(count)));
    };
    for (const Box& box : boxes) {
        const double x = (box.middle().x - whole.xmin) / whole.width();
        const double y = (box.middle().y - whole.ymin) / whole.height();
        found.push_back(index(y, cells.rows) * cells.columns + index(x, cells.columns));
    }
    return found;
}

/// True if the tiles of each cell fit the bed. Cells only grow, so the first one that is too large decides.
bool all_fit(const std::vector<Box>& boxes, const std::vector<std::size_t>& cells, const Bed& bed,
             double reach) {
    std::map<std::size_t, Box> of_cell;
    for (std::size_t t = 0; t < boxes.size(); ++t) {
        const auto [entry, is_new] = of_cell.emplace(cells[t], boxes[t]);
        if (!is_new) entry->second = united(entry->second, boxes[t]);
        const Box around = grown(entry->second, reach);
        if (!fits(around.width(), around.height(), bed)) return false;
    }
    return true;
}

/// Split cells into groups of tiles that have sides in common; number the groups by their first tile.
std::vector<std::size_t> connected_groups(const std::vector<tiling::SharedSide>& sides,
                                          const std::vector<std::size_t>& cells) {
    base::DisjointSets connected(cells.size());
    for (const tiling::SharedSide& side : sides) {
        const std::size_t first = side.tiles[0];
        const std::size_t second = side.tiles[1];
        if (cells[first] == cells[second]) connected.unite(first, second);
    }
    std::map<std::size_t, std::size_t> number;
    std::vector<std::size_t> parts;
    for (std::size_t t = 0; t < cells.size(); ++t)
        parts.push_back(number.emplace(connected.first_of(t), number.size()).first->second);
    return parts;
}

void require_tiles_fit(const std::vector<Box>& boxes, const Bed& bed, double reach) {
    for (std::size_t t = 0; t < boxes.size(); ++t) {
        const Box around = grown(boxes[t], reach);
        if (fits(around.width(), around.height(), bed)) continue;
        const auto mm = [](double metres) { return base::format_number(std::ceil(metres * 1e4) / 10.0); };
        throw base::InputError("tile " + std::to_string(t) + " needs " +
                               mm(around.width() + 2.0 * bed.margin) + " x " +
                               mm(around.height() + 2.0 * bed.margin) +
                               " mm with its connectors and margins, and does not fit the bed");
    }
}

/// Grids whose cells fit the bed, the grid with the fewest cells first. Each grid is a list with the cell of
/// each tile. For each number of rows, only the grid with the fewest columns is listed.
std::vector<std::vector<std::size_t>> fitting_grids(const std::vector<Box>& boxes, const Bed& bed,
                                                    const PartRoom& room) {
    constexpr std::size_t kMost = 6;
    Box whole = boxes.front();
    for (const Box& box : boxes) whole = united(whole, box);
    std::multimap<std::size_t, std::vector<std::size_t>> found;
    for (std::size_t rows = 1; rows <= boxes.size(); ++rows) {
        if (found.size() >= kMost && rows > std::next(found.begin(), kMost - 1)->first) break;
        for (std::size_t columns = 1; columns <= boxes.size(); ++columns) {
            room.control.check();
            auto cells = cells_of_tiles(boxes, whole, {columns, rows});
            if (!all_fit(boxes, cells, bed, room.reach)) continue;
            found.emplace(rows * columns, std::move(cells));
            break;
        }
    }
    std::vector<std::vector<std::size_t>> grids;
    for (auto& [count, cells] : found)
        if (grids.size() < kMost) grids.push_back(std::move(cells));
    if (grids.empty()) {  // every grid has a cell that is too large: each tile becomes a part
        grids.emplace_back(boxes.size());
        std::iota(grids.front().begin(), grids.front().end(), std::size_t{0});
    }
    return grids;
}

/// The crossings of a surface; those beside holes are tight, because a connector would fill the holes.
std::vector<Crossing> crossings_with_room(const tiling::Tessellation& tessellation,
                                          std::span<const tiling::SharedSide> sides, const PartRoom& room) {
    std::vector<Crossing> crossings = crossings_of(tessellation, sides, room.connector);
    for (Crossing& crossing : crossings) {
        const auto is_beside = [&](const Point2& hole) {
            return distance(hole, crossing.place) <= room.connector + room.hole_radius;
        };
        crossing.is_tight = crossing.is_tight || std::ranges::any_of(room.holes, is_beside);
    }
    return crossings;
}

}  // namespace

base::IndexVector<TileIndex, std::size_t> parts_of_tiles(const tiling::Tessellation& tessellation,
                                                         const Bed& bed, const PartRoom& room) {
    const std::vector<Box> boxes = tile_boxes(tessellation);
    require_tiles_fit(boxes, bed, room.reach);
    const auto fits_bed = [&](const Box& box) {
        const Box around = grown(box, room.reach);
        return fits(around.width(), around.height(), bed);
    };
    const SeamRules rules{fits_bed, room.control};
    const auto sides = tiling::shared_sides(tessellation);
    const auto grids = fitting_grids(boxes, bed, room);
    std::optional<std::vector<Crossing>> crossings;
    for (const auto& cells : grids) {
        std::vector<std::size_t> parts = connected_groups(sides, cells);
        // One part has no seam.
        if (std::ranges::count(parts, parts.front()) == std::ssize(parts)) return parts;
        if (!crossings) crossings = crossings_with_room(tessellation, sides, room);
        if (make_room(*crossings, boxes, rules, parts)) return connected_groups(sides, parts);
    }
    return connected_groups(sides, grids.front());
}

std::vector<Nest> nested(const std::vector<Box>& boxes, const Bed& bed) {
    std::vector<Nest> nests(boxes.size());
    std::vector<std::size_t> order(boxes.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    const double across = bed.width - 2.0 * bed.margin + kRounding;
    const double up = bed.height - 2.0 * bed.margin + kRounding;
    for (std::size_t i = 0; i < boxes.size(); ++i)
        nests[i].is_turned = boxes[i].width() > across || boxes[i].height() > up;
    const auto width = [&](std::size_t i) {
        return nests[i].is_turned ? boxes[i].height() : boxes[i].width();
    };
    const auto height = [&](std::size_t i) {
        return nests[i].is_turned ? boxes[i].width() : boxes[i].height();
    };
    std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) { return height(a) > height(b); });
    struct Row {
        std::size_t sheet;
        double y;
        double height;
        double x;  ///< where the next box goes
    };
    std::vector<Row> rows;
    std::vector<double> tops;  // by sheet: start of the next row
    for (const std::size_t i : order) {
        const auto fitting = std::ranges::find_if(rows, [&](const Row& row) {
            return row.x + width(i) <= across && height(i) <= row.height + kRounding;
        });
        auto row = fitting;
        if (row == rows.end()) {
            std::size_t sheet = 0;
            while (sheet < tops.size() && tops[sheet] + height(i) > up) ++sheet;
            if (sheet == tops.size()) tops.push_back(0.0);
            row = rows.insert(rows.end(), {sheet, tops[sheet], height(i), 0.0});
            tops[sheet] += height(i) + bed.spacing;
        }
        nests[i].sheet = row->sheet;
        nests[i].corner = {bed.margin + row->x, bed.margin + row->y};
        row->x += width(i) + bed.spacing;
    }
    return nests;
}

}  // namespace fretwork::fabrication::detail
