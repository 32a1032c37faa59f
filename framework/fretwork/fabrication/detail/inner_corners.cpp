// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/fabrication/detail/fillets.hpp>
#include <fretwork/geometry/plane.hpp>

namespace fretwork::fabrication::detail {
namespace {

using geometry::Point2;

/// Add the radii of inner corners. The material lies on the left, so the contour turns right there.
void look_at(const Contour& contour, std::vector<double>& radii) {
    if (contour.size() == 2) return;  // the circle of a hole
    for (std::size_t i = 0; i < contour.size(); ++i) {
        const ContourPoint& before = contour[(i + contour.size() - 1) % contour.size()];
        const Point2& after = contour[(i + 1) % contour.size()].place;
        if (contour[i].bulge < 0.0) radii.push_back(arc_between(contour[i], after).radius);
        if (contour[i].bulge != 0.0 || before.bulge != 0.0) continue;
        const Point2 in = contour[i].place - before.place;
        const Point2 out = after - contour[i].place;
        if (turn(in, out) < -kLeastCornerTurn) radii.push_back(0.0);
    }
}

}  // namespace

std::vector<double> inner_corner_radii(const Shape& shape) {
    std::vector<double> radii;
    for (const Piece& piece : shape.pieces) {
        look_at(piece.outer, radii);
        for (const Contour& opening : piece.openings) look_at(opening, radii);
    }
    return radii;
}

}  // namespace fretwork::fabrication::detail
