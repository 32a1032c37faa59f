// SPDX-License-Identifier: GPL-3.0-or-later
// Annotations of drawings: scale bars, legends, captions.
#pragma once

#include <fretwork/exports/drawings/detail/svg_canvas.hpp>

#include <span>
#include <string>

namespace fretwork::exports::detail {

inline constexpr const char* kBeamColour = "#22303c";
inline constexpr const char* kRimColour = "#b8c0c8";
inline constexpr const char* kReducedColour = "#2b8cbe";  ///< of a reduced model
inline constexpr const char* kTextColour = "#333333";

/// The height of text in a drawing of some width, metres.
double text_height(double drawing_width);
/// About how wide a text of some height is.
double text_width(std::string_view text, double height);
/// "12.5 mm"
std::string millimetres(double metres);
/// A number with three digits.
std::string short_number(double value);

/// A bar of a round length, at most a fifth of the drawing's width, with its length above it. Its left end is
/// at `start`.
void draw_scale_bar(SvgCanvas& canvas, const geometry::Point2& start);

/// A line of the given look, as a legend has it, on the text line that starts at `place`. Returns where the
/// text begins.
geometry::Point2 draw_line_sample(SvgCanvas& canvas, const geometry::Point2& place, const Style& style);

}  // namespace fretwork::exports::detail
