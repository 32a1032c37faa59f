// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/fabrication/contour.hpp>
#include <fretwork/fabrication/shape.hpp>

#include <vector>

namespace fretwork::fabrication::detail {

/// Round the inner corners of the material: the corners between two straight lines where the contour turns
/// right (the material lies on its left). The radius (m) is smaller where two arcs would meet on a line.
Contour with_fillets(const Contour& contour, double radius);

/// A corner that turns by a smaller angle (rad) counts as straight and gets no fillet.
inline constexpr double kLeastCornerTurn = 0.01;

/// The radius of each inner corner of the material between two straight lines, m; 0: sharp. Holes for bolts
/// are no corners.
std::vector<double> inner_corner_radii(const Shape& shape);

}  // namespace fretwork::fabrication::detail
