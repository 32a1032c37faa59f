// SPDX-License-Identifier: GPL-3.0-or-later
// Annotations of drawings: scale bars, legends, captions.
#pragma once

#include <fretwork/exports/drawings/detail/svg_canvas.hpp>

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace fretwork::exports::detail {

inline constexpr const char* kBeamColour = "#22303c";
inline constexpr const char* kRimColour = "#b8c0c8";
inline constexpr const char* kReducedColour = "#2b8cbe";  ///< of a reduced model
inline constexpr const char* kTextColour = "#333333";

/// The height of text in a drawing of some width that is printed as wide as a column, metres.
double text_height(double drawing_width);
/// The approximate width of a text, in the unit of its height.
double text_width(std::string_view text, double height);
/// A text in lines that are at most `width` wide, broken behind blanks and before plus signs. A word that is
/// longer has a wider line of its own.
std::vector<std::string> lines_within(std::string_view text, double height, double width);
/// Write lines below each other, centred at the x of `place`; the first is at `place`. The lines are
/// `kLineStep` heights apart.
void write_lines(SvgCanvas& canvas, const geometry::Point2& place, std::span<const std::string> lines,
                 double height);
inline constexpr double kLineStep = 1.25;
/// "12.5 mm"
std::string millimetres(double metres);
/// A number with at most three digits.
std::string short_number(double value);

/// A bar of a round length, at most a fifth of the drawing's width, with its length above it in text of this
/// height. Its left end is at `start`.
void draw_scale_bar(SvgCanvas& canvas, const geometry::Point2& start, double height);

/// Draw a sample of a line style for a legend. It starts at `place`, before words in letters of this height.
/// Returns the place where the words start.
geometry::Point2 draw_line_sample(SvgCanvas& canvas, const geometry::Point2& place, const Style& style,
                                  double height);

}  // namespace fretwork::exports::detail
