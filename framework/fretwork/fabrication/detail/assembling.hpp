// SPDX-License-Identifier: GPL-3.0-or-later
// Which openings belong to which piece.
#pragma once

#include <fretwork/fabrication/shape.hpp>

#include <span>

namespace fretwork::fabrication::detail {

/// Pieces from contours, sorted from left to right. Counterclockwise contours become pieces; clockwise
/// contours become openings of the smallest piece around them. Throws GeometryError if none of several pieces
/// is around an opening.
std::vector<Piece> assembled(std::span<const Contour> contours);

/// The smallest piece whose outer contour is around a point. Throws GeometryError if there is none.
Piece& piece_around(Shape& shape, const geometry::Point2& point);

bool contains(const geometry::Polygon& polygon, const geometry::Point2& point);

}  // namespace fretwork::fabrication::detail
