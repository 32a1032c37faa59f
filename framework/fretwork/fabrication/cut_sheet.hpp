// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/fabrication/shape.hpp>
#include <fretwork/simulation/surface.hpp>

#include <string>
#include <vector>

namespace fretwork::fabrication {

/// A line of text, centred at a place.
struct Label {
    geometry::Point2 place;  ///< m
    std::string text;        ///< text
    double height = 0.0;     ///< m
};

/// The input of a cutter: one sheet of material.
struct CutSheet {
    std::string title;              ///< title of the drawing
    std::vector<Piece> pieces;      ///< pieces to be cut along their contours
    std::vector<Label> engraved;    ///< marks on the material
    std::vector<Label> labels;      ///< text that the cutter ignores
    std::vector<Contour> guides{};  ///< lines that the cutter ignores, such as the edge of the material
};

/// The whole surface in one sheet, with the numbers of its tiles as labels. Throws as make_shape().
CutSheet whole_sheet(const simulation::Surface& surface, const ShapeOptions& options);
/// The sheet with a given shape of the surface.
CutSheet sheet_of_shape(const simulation::Surface& surface, const Shape& shape);

/// Labels with the numbers of the tiles, at the tiles' centers.
std::vector<Label> tile_labels(const tiling::Tessellation& tessellation);

/// The box around all pieces and guides of a sheet, without its text. Pre: the sheet has a piece.
geometry::Box box_of(const CutSheet& sheet);

}  // namespace fretwork::fabrication
