// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/fabrication/cut_sheet.hpp>

namespace fretwork::fabrication {

using geometry::Box;

std::vector<Label> tile_labels(const tiling::Tessellation& tessellation) {
    constexpr double kHeight = 0.12;  // share of a tile's side
    std::vector<Label> labels;
    for (std::size_t t = 0; t < tessellation.tiles.size(); ++t) {
        const geometry::Polygon polygon = tiling::tile_polygon(tessellation, TileIndex(t));
        labels.push_back(
            {geometry::centroid(polygon), std::to_string(t), kHeight * geometry::mean_side(polygon)});
    }
    return labels;
}

CutSheet whole_sheet(const simulation::Surface& surface, const ShapeOptions& options) {
    return sheet_of_shape(surface, make_shape(surface, options));
}

CutSheet sheet_of_shape(const simulation::Surface& surface, const Shape& shape) {
    return {.title = "Surface of " + std::to_string(surface.tessellation.tiles.size()) + " tiles",
            .pieces = shape.pieces,
            .engraved = {},
            .labels = tile_labels(surface.tessellation)};
}

Box box_of(const CutSheet& sheet) {
    Box box = box_of(sheet.pieces.front().outer);
    for (const Piece& piece : sheet.pieces) box = united(box, box_of(piece.outer));
    for (const Contour& guide : sheet.guides) box = united(box, box_of(guide));
    return box;
}

}  // namespace fretwork::fabrication
