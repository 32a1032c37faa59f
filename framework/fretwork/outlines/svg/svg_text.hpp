// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/outlines/detail/bezier.hpp>

#include <string>
#include <string_view>
#include <vector>

/// Parsers of the texts inside SVG attributes (SVG 1.1, chapters 4, 7 and 8). Each parser throws InputError
/// that quotes the text, and states the number of the invalid character, from 1, and the expected content.
namespace fretwork::outlines::detail {

/// A reader that goes through the text of an attribute.
class SvgText {
  public:
    explicit SvgText(std::string_view text) : text_(text) {}

    [[nodiscard]] bool at_end();            ///< true if nothing but white space and commas is left
    [[nodiscard]] bool at_number();         ///< true if a number follows, after white space and commas
    [[nodiscard]] double number();          ///< a finite number
    [[nodiscard]] bool flag();              ///< 0 or 1; no separator needs to follow
    [[nodiscard]] char letter();            ///< an ASCII letter, after white space and commas
    [[nodiscard]] std::string_view word();  ///< letters and %, possibly none; does not skip separators
    void expect(char wanted);
    [[noreturn]] void fail(const std::string& message) const;

  private:
    void skip_separators();
    std::string_view text_;
    std::size_t next_ = 0;
};

/// Parse the attribute `d` of a path.
std::vector<Subpath> parse_svg_path(std::string_view text);
/// Parse the attribute `points` of a polygon or polyline.
std::vector<geometry::Point2> parse_svg_points(std::string_view text);
/// Parse a `transform`, from an attribute or from a style sheet (with units).
Affine parse_svg_transform(std::string_view text);
/// A length in user units (a number with or without px, mm, cm, in, pt, pc, Q; 96 px to an inch), or relative
/// to the viewport (percent) or the font size (em, ex or rem).
struct SvgLength {
    double value = 0.0;  ///< multiple of the unit; 50 % has the value 0.5
    enum class Unit { Pixel, Percent, Em, Rem } unit = Unit::Pixel;
};
SvgLength parse_svg_length(std::string_view text);

}  // namespace fretwork::outlines::detail
