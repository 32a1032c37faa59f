// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/outlines/regions/filled_region.hpp>
#include <fretwork/outlines/svg/svg_document.hpp>

#include <string>

namespace fretwork::outlines::detail {

/// The inherited properties that decide about fill and stroke.
struct SvgStyle {
    enum class Paint { None, Some };
    Paint fill = Paint::Some;
    Paint stroke = Paint::None;
    double fill_opacity = 1.0;
    double stroke_opacity = 1.0;
    enum class StrokeWidth { Zero, Some } stroke_width = StrokeWidth::Some;
    FillRule fill_rule = FillRule::Nonzero;
    FillRule clip_rule = FillRule::Nonzero;
    enum class Visibility { Visible, Hidden } visibility = Visibility::Visible;
    double font_size = 16.0;                 ///< pixels
    std::string fill_colour = "#000000";     ///< "#rrggbb"; empty: no plain colour, such as a gradient
    std::string current_colour = "#000000";  ///< value of the property `color`

    [[nodiscard]] bool is_filled() const {
        return fill == Paint::Some && fill_opacity > 0 && visibility == Visibility::Visible;
    }
    [[nodiscard]] bool is_stroked() const {
        return stroke == Paint::Some && stroke_opacity > 0 && stroke_width == StrokeWidth::Some &&
               visibility == Visibility::Visible;
    }
};

/// The style of an element in a parent with the style `outer`. Throws as SvgDocument::charge().
SvgStyle style_in(const SvgStyle& outer, const SvgProperties& properties, const SvgDocument& document);

/// True if an element and its content are not shown: `display: none`, `opacity: 0`.
bool is_switched_off(const SvgProperties& properties);

/// True if the conditions of an element (language, extensions) hold in a browser set to English. Throws as
/// SvgDocument::charge().
bool meets_conditions(pugi::xml_node node, const SvgDocument& document);

}  // namespace fretwork::outlines::detail
