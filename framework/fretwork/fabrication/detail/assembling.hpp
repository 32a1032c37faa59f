// SPDX-License-Identifier: GPL-3.0-or-later
// Which openings belong to which piece.
#pragma once

#include <fretwork/fabrication/shape.hpp>

#include <span>

namespace fretwork::fabrication::detail {

/// Counterclockwise contours become pieces, clockwise ones openings of the smallest piece around them.
std::vector<Piece> assembled(std::span<const Contour> contours);

/// The piece that has a point of material. Throws GeometryError if none has.
Piece& piece_around(Shape& shape, const geometry::Point2& point);

bool contains(const geometry::Polygon& polygon, const geometry::Point2& point);

}  // namespace fretwork::fabrication::detail
