// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/geometry/internal/message_text.hpp>
#include <fretwork/geometry/nearly_convex.hpp>
#include <fretwork/geometry/plane.hpp>
#include <fretwork/outlines/flat_mesh.hpp>
#include <fretwork/outlines/outline_check.hpp>
#include <fretwork/tiling/dual/cell_sides.hpp>
#include <fretwork/tiling/dual/measures.hpp>
#include <fretwork/tiling/dual/numbering.hpp>
#include <fretwork/tiling/dual/rim_of_dual.hpp>
#include <fretwork/tiling/tessellate.hpp>

#include <algorithm>

namespace fretwork::tiling {
namespace {

using detail::Dual;
using geometry::Point2;
using geometry::Polygon;

class MeshTiles {
  public:
    explicit MeshTiles(const std::filesystem::path& path) : path_(path) {
        const outlines::MeshFile file = outlines::read_flat_mesh(path);
        for (const auto& [x, y, z] : file.points) dual_.vertices.push_back({{x, y}});
        for (const std::vector<int>& face : file.faces) dual_.cells.emplace_back(face.begin(), face.end());
        double area = 0.0;
        for (std::size_t face = 0; face < dual_.cells.size(); ++face)
            area += geometry::signed_area(detail::polygon_of(dual_, face));
        if (area > 0) return;
        for (detail::Cell& face : dual_.cells) std::ranges::reverse(face);
    }

    Dual run() {
        for (std::size_t face = 0; face < dual_.cells.size(); ++face) {
            const Polygon polygon = detail::polygon_of(dual_, face);
            if (!geometry::is_nearly_convex(polygon))
                fail(face, "is not convex, or runs the other way around than most faces" +
                               geometry::inward_bend_text(polygon));
        }
        check_sides();
        check_rim();
        return std::move(dual_);
    }

  private:
    [[noreturn]] void fail(std::size_t face, const std::string& message) const {
        throw base::GeometryError(path_.string(), "face " + std::to_string(face), message);
    }
    [[nodiscard]] std::string place_of(detail::DualVertexIndex vertex) const {
        return geometry::place_text(dual_.vertices[vertex].place);
    }

    void check_sides() {
        const auto sides = detail::sides_of_cells(dual_, {});
        detail::for_each_side(sides, {}, [&](std::span<const detail::CellSide> same) {
            if (same.size() == 1) {
                rim_sides_.push_back(same.front());
            } else if (same.size() > 2 || same[0].from == same[1].from) {
                fail(same.back().cell, "has a side at " + place_of(same.back().from) + "; face " +
                                           std::to_string(same.front().cell) +
                                           " lies on the same side of it, or three faces share it");
            }
        });
        const detail::Pieces pieces = detail::pieces_of(dual_, {});
        if (pieces.count > 1)
            fail(pieces.cell_of_smallest, "is not connected to the others by sides: there are " +
                                              std::to_string(pieces.count) + " pieces");
    }

    void check_rim() {
        const detail::DualRim rim = detail::rim_of(dual_, {});
        if (!rim.knots.empty())
            fail(face_with(rim.knots.front()),
                 "touches another face at " + place_of(rim.knots.front()) + " in this vertex alone");
        for (std::size_t line = 0; line < rim.lines.size(); ++line) {
            // A valid loop, no matter which, marks a rim vertex.
            for (const detail::DualVertexIndex v : rim.lines[line])
                dual_.vertices[v].loop = detail::LoopIndex(line);
        }
        const std::vector<Polygon> loops = detail::loops_of(dual_, rim);
        const auto crossings = outlines::places_of_crossings(loops, {});
        if (!crossings.empty())
            fail(face_at(crossings.front()), "has a side that touches or crosses another, near " +
                                                 geometry::place_text(crossings.front()) +
                                                 ": faces share whole sides, and do not overlap");
    }
    [[nodiscard]] std::size_t face_with(detail::DualVertexIndex vertex) const {
        const auto has = [&](const detail::Cell& face) { return std::ranges::count(face, vertex) > 0; };
        return std::ranges::find_if(dual_.cells, has) - dual_.cells.begin();
    }
    /// The face with the rim side whose middle is nearest to a place.
    [[nodiscard]] std::size_t face_at(Point2 place) const {
        const auto off = [&](const detail::CellSide& side) {
            const Point2 from = dual_.vertices[side.from].place;
            const Point2 to = dual_.vertices[side.to].place;
            return geometry::distance(geometry::between(from, to, 0.5), place);
        };
        return std::ranges::min_element(rim_sides_, {}, off)->cell;
    }

    const std::filesystem::path& path_;
    Dual dual_;
    std::vector<detail::CellSide> rim_sides_;
};

}  // namespace

TessellationResult read_mesh_tessellation(const std::filesystem::path& path,
                                          const pattern::NodeLayout& layout) {
    const Dual dual = MeshTiles(path).run();
    TessellationResult result{detail::number(dual, layout, {}), {}};
    result.report = detail::measure(dual, detail::SizeField(1.0), {}).report;
    result.report.covered_share = 1.0;
    result.report.start = "mesh";
    return result;
}

}  // namespace fretwork::tiling
