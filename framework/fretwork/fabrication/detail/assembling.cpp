// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/fabrication/detail/assembling.hpp>
#include <fretwork/fabrication/detail/length_text.hpp>
#include <fretwork/geometry/plane.hpp>

#include <algorithm>

namespace fretwork::fabrication::detail {
namespace {

using geometry::Box;
using geometry::Point2;

/// A piece, prepared for the search around a point.
struct Candidate {
    geometry::Polygon polygon;
    Box box;
    double area = 0.0;
};

constexpr double kChordTolerance = 1e-6;  // m

Candidate candidate(const Piece& piece) {
    return {flattened(piece.outer, kChordTolerance), box_of(piece.outer), signed_area(piece.outer)};
}

/// The index of the smallest candidate around a point; candidates.size(): none.
std::size_t smallest_around(std::span<const Candidate> candidates, const Point2& point) {
    std::size_t found = candidates.size();
    for (std::size_t i = 0; i < candidates.size(); ++i) {
        const Candidate& one = candidates[i];
        if (!one.box.meets({point.x, point.y, point.x, point.y})) continue;
        if (found < candidates.size() && candidates[found].area <= one.area) continue;
        if (contains(one.polygon, point)) found = i;
    }
    return found;
}

[[noreturn]] void fail(const Point2& point) {
    throw base::GeometryError("no piece of material is around " + place_text(point));
}

}  // namespace

bool contains(const geometry::Polygon& polygon, const Point2& point) {
    bool inside = false;
    for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
        const Point2& a = polygon[i];
        const Point2& b = polygon[j];
        if ((a.y > point.y) == (b.y > point.y)) continue;
        if (point.x < a.x + (point.y - a.y) / (b.y - a.y) * (b.x - a.x)) inside = !inside;
    }
    return inside;
}

std::vector<Piece> assembled(std::span<const Contour> contours) {
    std::vector<Piece> pieces;
    for (const Contour& contour : contours)
        if (signed_area(contour) > 0.0) pieces.push_back({contour, {}});
    std::ranges::sort(pieces, {}, [](const Piece& piece) {
        const Box box = box_of(piece.outer);
        return std::pair(box.xmin, box.ymin);
    });
    std::vector<Candidate> candidates;
    if (pieces.size() > 1)
        for (const Piece& piece : pieces) candidates.push_back(candidate(piece));
    for (const Contour& contour : contours) {
        if (signed_area(contour) > 0.0) continue;
        const std::size_t home = pieces.size() == 1 ? 0 : smallest_around(candidates, contour.front().place);
        if (home >= pieces.size()) fail(contour.front().place);
        pieces[home].openings.push_back(contour);
    }
    return pieces;
}

Piece& piece_around(Shape& shape, const Point2& point) {
    std::vector<Candidate> candidates;
    for (const Piece& piece : shape.pieces) candidates.push_back(candidate(piece));
    const std::size_t home = smallest_around(candidates, point);
    if (home >= shape.pieces.size()) fail(point);
    return shape.pieces[home];
}

}  // namespace fretwork::fabrication::detail
