// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/outlines/detail/remarks.hpp>

namespace fretwork::outlines::detail {

/// The lines of a drawing, metres.
struct DrawnLines {
    std::vector<geometry::Polygon> closed;
    std::vector<geometry::Polygon> open;  ///< each has two points or more
};

/// The curves around the regions that lines enclose.
struct Enclosed {
    std::vector<geometry::Polygon> curves;  ///< a curve that is drawn several times appears once
    std::vector<std::size_t> open;          ///< the indices of the open lines that enclose nothing
};

/// The distance, m, up to which loose ends are joined.
double widest_gap(double tolerance);

/// Join the open lines into closed curves, and add the closed lines. Remarks report closed gaps and lines
/// drawn twice. `tolerance` is the tolerance of flattening, m. Throws GeometryError as contours_of() and
/// join_lines().
Enclosed enclosed_by(DrawnLines lines, double tolerance, Remarks& remarks);

/// The index of the longest of the lines `which`, by the diagonals of their boxes. Pre: `which` is not empty.
std::size_t longest_of(const std::vector<geometry::Polygon>& lines, const std::vector<std::size_t>& which);

/// Add a remark that the open lines `which` are left out; `place` says where the longest lies. Pre: `which`
/// is not empty.
void leave_out_open(const std::vector<geometry::Polygon>& lines, const std::vector<std::size_t>& which,
                    const std::string& place, Remarks& remarks);

}  // namespace fretwork::outlines::detail
