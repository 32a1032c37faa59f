// SPDX-License-Identifier: GPL-3.0-or-later
// Parts moved from the surface to their places on sheets.
#pragma once

#include <fretwork/fabrication/cut_sheet.hpp>
#include <fretwork/geometry/plane.hpp>

#include <utility>

namespace fretwork::fabrication::detail {

/// A motion: a quarter turn or none, then a shift.
struct Motion {
    bool is_turned = false;
    geometry::Point2 shift;
    [[nodiscard]] geometry::Point2 operator()(const geometry::Point2& point) const {
        return (is_turned ? left_of(point) : point) + shift;
    }
};

inline Contour moved(Contour contour, const Motion& motion) {
    for (ContourPoint& point : contour) point.place = motion(point.place);
    return contour;
}
inline Piece moved(const Piece& piece, const Motion& motion) {
    Piece other{moved(piece.outer, motion), {}};
    for (const Contour& opening : piece.openings) other.openings.push_back(moved(opening, motion));
    return other;
}
inline void append_moved(CutSheet& sheet, const CutSheet& other, const Motion& motion) {
    for (const Piece& piece : other.pieces) sheet.pieces.push_back(moved(piece, motion));
    for (const Contour& guide : other.guides) sheet.guides.push_back(moved(guide, motion));
    for (const auto& [from, to] :
         {std::pair{&other.engraved, &sheet.engraved}, {&other.labels, &sheet.labels}})
        for (const Label& label : *from) to->push_back({motion(label.place), label.text, label.height});
}

}  // namespace fretwork::fabrication::detail
