// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/text.hpp>
#include <fretwork/geometry/box.hpp>
#include <fretwork/outlines/detail/outline_readers.hpp>
#include <fretwork/outlines/regions/drawn_lines.hpp>
#include <fretwork/outlines/regions/filled_region.hpp>
#include <fretwork/outlines/regions/line_joining.hpp>

#include <algorithm>

namespace fretwork::outlines::detail {
namespace {

using geometry::Polygon;

/// The largest distance at which loose ends are joined, m. In drawings smaller than a thousand times this
/// distance, loose ends are joined up to a thousandth of the drawing's size.
constexpr double kWidestGap = 2e-4;
constexpr double kGapPerTolerance = kDetail / 1000;
/// The distance, as a share of the flattening tolerance, below which two ends are one point, because drawings
/// are rounded.
constexpr double kSameShare = 0.5;

double width_of(const Polygon& line) {
    return geometry::box_of(line).diagonal();
}

}  // namespace

double widest_gap(double tolerance) {
    return std::min(kWidestGap, kGapPerTolerance * tolerance);
}

Enclosed enclosed_by(DrawnLines lines, double tolerance, Remarks& remarks) {
    const double same = kSameShare * tolerance;
    JoinedLines joined = join_lines(lines.open, {same, widest_gap(tolerance)});
    Contours contours = contours_of(joined.lines);
    Enclosed enclosed;
    const std::size_t lines_without_gaps = joined.lines.size() - joined.gaps;
    for (const std::size_t line : contours.open)
        if (line < lines_without_gaps && joined.lines[line].size() > 1)
            enclosed.open.push_back(joined.given[line]);
    std::ranges::move(contours.closed, std::back_inserter(lines.closed));
    DistinctCurves distinct = distinct_curves(std::move(lines.closed), same);
    enclosed.curves = std::move(distinct.curves);
    if (joined.gaps > 0)
        remarks.add(base::counted(joined.gaps, "gap") + " of at most " +
                    roughly_in_millimetres(joined.widest_gap) + " mm closed");
    if (const int doubled = joined.doubled + distinct.doubled; doubled > 0)
        remarks.add(base::counted(doubled, "doubled line") + " taken once");
    return enclosed;
}

std::size_t longest_of(const std::vector<Polygon>& lines, const std::vector<std::size_t>& which) {
    return *std::ranges::max_element(which, {}, [&](std::size_t line) { return width_of(lines[line]); });
}

void leave_out_open(const std::vector<Polygon>& lines, const std::vector<std::size_t>& which,
                    const std::string& place, Remarks& remarks) {
    remarks.leave_out("open line" + std::string(which.size() == 1 ? "" : "s") + " (the longest, " +
                          in_millimetres(width_of(lines[longest_of(lines, which)])) + " mm, at " + place +
                          ")",
                      static_cast<int>(which.size()));
}

}  // namespace fretwork::outlines::detail
