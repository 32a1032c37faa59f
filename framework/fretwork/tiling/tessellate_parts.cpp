// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/geometry/plane.hpp>
#include <fretwork/tiling/tessellate.hpp>

#include <algorithm>
#include <cmath>

namespace fretwork::tiling {
namespace {

void append(Tessellation& whole, const Tessellation& part) {
    const auto vertices = static_cast<int>(whole.vertices.size());
    const auto nodes = static_cast<int>(whole.interface_nodes.size());
    for (Tile tile : part.tiles) {
        for (VertexIndex& vertex : tile.vertices) vertex = VertexIndex(static_cast<int>(vertex) + vertices);
        for (InterfaceIndex& node : tile.interface_nodes)
            node = InterfaceIndex(static_cast<int>(node) + nodes);
        whole.tiles.push_back(std::move(tile));
    }
    whole.vertices.insert(whole.vertices.end(), part.vertices.begin(), part.vertices.end());
    whole.interface_nodes.insert(whole.interface_nodes.end(), part.interface_nodes.begin(),
                                 part.interface_nodes.end());
}

/// Merge the shares and means of two sets of tiles, weighted by the numbers of tiles.
void merge(TessellationReport& whole, const TessellationReport& part) {
    const double of_part = static_cast<double>(part.tiles) / (whole.tiles + part.tiles);
    const auto mean = [&](double a, double b) { return a + of_part * (b - a); };
    const double apart = part.mean_side - whole.mean_side;
    const double variance = mean(whole.sd_side * whole.sd_side, part.sd_side * part.sd_side) +
                            of_part * (1 - of_part) * apart * apart;
    whole.mean_side = mean(whole.mean_side, part.mean_side);
    whole.sd_side = std::sqrt(variance);
    whole.smallest_side = std::min(whole.smallest_side, part.smallest_side);
    whole.largest_side = std::max(whole.largest_side, part.largest_side);
    whole.smallest_angle = std::min(whole.smallest_angle, part.smallest_angle);
    whole.hexagon_share = mean(whole.hexagon_share, part.hexagon_share);
    whole.refined_share = mean(whole.refined_share, part.refined_share);
    const int inner = whole.inner_tiles + part.inner_tiles;
    if (inner > 0)
        whole.inner_hexagon_share =
            (whole.inner_hexagon_share * whole.inner_tiles + part.inner_hexagon_share * part.inner_tiles) /
            inner;
    whole.inner_tiles = inner;
    whole.tiles += part.tiles;
    whole.negligible_points += part.negligible_points;
}

TessellationResult tessellate_part(const std::vector<outlines::Outline>& parts, std::size_t part,
                                   const pattern::NodeLayout& layout, const TessellationOptions& options) {
    const std::string name = "part " + std::to_string(part + 1) + " of " + std::to_string(parts.size());
    return base::located<base::GeometryError>(name, "",
                                              [&] { return tessellate(parts[part], layout, options); });
}

}  // namespace

TessellationResult tessellate_parts(const std::vector<outlines::Outline>& parts,
                                    const pattern::NodeLayout& layout, const TessellationOptions& options) {
    if (parts.empty()) throw base::InputError("there is no outline to tile");
    if (parts.size() == 1) return tessellate(parts.front(), layout, options);
    TessellationResult whole = tessellate_part(parts, 0, layout, options);
    double area = outlines::area_of(parts.front());
    double covered = area * whole.report.covered_share;
    double outside = area * whole.report.outside_share;
    for (std::size_t part = 1; part < parts.size(); ++part) {
        const TessellationResult next = tessellate_part(parts, part, layout, options);
        append(whole.tessellation, next.tessellation);
        merge(whole.report, next.report);
        area += outlines::area_of(parts[part]);
        covered += outlines::area_of(parts[part]) * next.report.covered_share;
        outside += outlines::area_of(parts[part]) * next.report.outside_share;
    }
    whole.report.covered_share = covered / area;
    whole.report.outside_share = outside / area;
    return whole;
}

}  // namespace fretwork::tiling
