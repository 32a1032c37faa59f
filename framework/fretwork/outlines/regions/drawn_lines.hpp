// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/outlines/detail/remarks.hpp>

namespace fretwork::outlines::detail {

/// The lines of a drawing, metres.
struct DrawnLines {
    std::vector<geometry::Polygon> closed;
    std::vector<geometry::Polygon> open;  ///< of two points or more
};

/// The regions that lines enclose.
struct Enclosed {
    std::vector<geometry::Polygon> curves;  ///< each once, however often it is drawn
    std::vector<std::size_t> open;  ///< the open lines that enclose nothing, by their place in the list
};

/// Loose ends nearer than this to each other are joined, metres.
double widest_gap(double tolerance);

/// Join the open lines to closed curves, and add the closed ones. The remarks say which gaps were closed and
/// what was drawn twice. `tolerance` is that of flattening, metres.
Enclosed enclosed_by(DrawnLines lines, double tolerance, Remarks& remarks);

/// The longest of some lines: of those with the numbers `which`, at least one.
std::size_t longest_of(const std::vector<geometry::Polygon>& lines, const std::vector<std::size_t>& which);

/// Leave out the open lines with the numbers `which` (at least one); `place` says where the longest is.
void leave_out_open(const std::vector<geometry::Polygon>& lines, const std::vector<std::size_t>& which,
                    const std::string& place, Remarks& remarks);

}  // namespace fretwork::outlines::detail
