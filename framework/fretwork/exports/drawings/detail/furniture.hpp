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
/// About how wide a text of some height is.
double text_width(std::string_view text, double height);
/// A text in lines that are at most `width` wide, broken behind blanks and before plus signs. What cannot be
/// broken may be wider.
std::vector<std::string> lines_within(std::string_view text, double height, double width);
/// Write lines below each other in the middle of `place`, the first at `place`. The lines are `kLineStep`
/// heights apart.
void write_lines(SvgCanvas& canvas, const geometry::Point2& place, std::span<const std::string> lines,
                 double height);
inline constexpr double kLineStep = 1.25;
/// "12.5 mm"
std::string millimetres(double metres);
/// A number with three digits.
std::string short_number(double value);

/// A bar of a round length, at most a fifth of the drawing's width, with its length above it in text of this
/// height. Its left end is at `start`.
void draw_scale_bar(SvgCanvas& canvas, const geometry::Point2& start, double height);

/// A line of the given look, as a legend has it, on the line of text of this height that starts at `place`.
/// Returns where the text begins.
geometry::Point2 draw_line_sample(SvgCanvas& canvas, const geometry::Point2& place, const Style& style,
                                  double height);

}  // namespace fretwork::exports::detail
