// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/text.hpp>
#include <fretwork/outlines/svg/css.hpp>
#include <fretwork/outlines/svg/svg_style.hpp>
#include <fretwork/outlines/svg/svg_text.hpp>

#include <algorithm>
#include <optional>

namespace fretwork::outlines::detail {
namespace {

/// A number or a percentage, limited to 0 .. 1; nothing if the text is neither.
std::optional<double> share_of(std::string_view text) {
    try {
        const SvgLength length = parse_svg_length(text);
        if (length.unit != SvgLength::Unit::Pixel && length.unit != SvgLength::Unit::Percent)
            return std::nullopt;
        return std::clamp(length.value, 0.0, 1.0);
    } catch (const base::InputError&) {
        return std::nullopt;  // CSS ignores a declaration that cannot be read
    }
}

/// True for a colour with alpha zero: rgba(0, 0, 0, 0), rgb(0 0 0 / 0%), #0000, #00000000.
bool has_alpha_zero(std::string_view color) {
    if (color.starts_with('#')) {
        return (color.size() == 5 && color.back() == '0') || (color.size() == 9 && color.ends_with("00"));
    }
    const std::size_t open = color.find('(');
    if (open == std::string_view::npos || !color.ends_with(')')) return false;
    const std::string_view inside = color.substr(open + 1, color.size() - open - 2);
    std::size_t at = inside.find('/');
    if (at == std::string_view::npos && std::ranges::count(inside, ',') == 3) at = inside.rfind(',');
    return at != std::string_view::npos && share_of(inside.substr(at + 1)) == 0.0;
}

/// False for a gradient without stops, or with transparent stops alone, which paints nothing.
bool paints(pugi::xml_node server, const SvgDocument& document) {
    if (!server) return false;
    const std::string_view name = document.name_of(server);
    if (name == "pattern") return true;
    if (name != "linearGradient" && name != "radialGradient") return false;
    for (int links = 0; server && links < 8; ++links) {
        document.charge(server);
        bool has_stops = false;
        for (const pugi::xml_node stop : server.children()) {
            document.charge(stop, 1);
            if (document.name_of(stop) != "stop") continue;
            has_stops = true;
            const SvgProperties properties(stop, document);
            if (share_of(properties.find("stop-opacity")) != 0.0 &&
                !has_alpha_zero(properties.find("stop-color")))
                return true;
        }
        if (has_stops) return false;
        const std::string_view link = server.attribute("href") ? server.attribute("href").value()
                                                               : server.attribute("xlink:href").value();
        server = document.referred(link);
    }
    return false;
}

SvgStyle::Paint paint_of(std::string_view text, SvgStyle::Paint outer, const SvgDocument& document) {
    using Paint = SvgStyle::Paint;
    const std::string value = base::in_small_letters(text);
    if (value.empty() || value == "inherit" || value == "unset") return outer;
    if (value == "none" || value == "transparent" || has_alpha_zero(value)) return Paint::None;
    if (!value.starts_with("url(")) return Paint::Some;
    if (paints(document.referred(text), document)) return Paint::Some;
    const std::size_t end = value.find(')');
    const std::size_t fallback = end == std::string::npos ? end : value.find_first_not_of(' ', end + 1);
    if (fallback == std::string::npos || document.referred(text)) return Paint::None;
    return value.substr(fallback) == "none" ? Paint::None : Paint::Some;
}

/// The colour that a property states; the inherited colour if the property states none.
std::string colour_of(std::string_view text, const std::string& outer, const std::string& current) {
    const std::string value = base::in_small_letters(text);
    if (value.empty() || value == "inherit" || value == "unset") return outer;
    if (value == "currentcolor") return current;
    return css_colour(value).value_or("");
}

FillRule rule_of(std::string_view text, FillRule outer) {
    if (text == "evenodd") return FillRule::Evenodd;
    return text == "nonzero" ? FillRule::Nonzero : outer;
}

/// The stroke width that a property states. A width that is below zero or cannot be read is ignored.
SvgStyle::StrokeWidth stroke_width_of(std::string_view text, SvgStyle::StrokeWidth outer) {
    if (text.empty()) return outer;
    try {
        const double width = parse_svg_length(text).value;
        if (width < 0) return outer;
        return width > 0 ? SvgStyle::StrokeWidth::Some : SvgStyle::StrokeWidth::Zero;
    } catch (const base::InputError&) {
        return outer;
    }
}

double font_size_of(std::string_view text, double outer) {
    if (text.empty()) return outer;
    try {
        const SvgLength size = parse_svg_length(text);
        switch (size.unit) {
            case SvgLength::Unit::Pixel:
                return size.value;
            case SvgLength::Unit::Rem:
                return 16 * size.value;
            default:
                return outer * size.value;
        }
    } catch (const base::InputError&) {
        return outer;  // such as "medium"
    }
}

/// True if a list of languages, such as "de, en-GB", contains English.
bool names_english(std::string_view list) {
    for (std::string word : base::split(list, ',')) {
        std::erase(word, ' ');
        word = base::in_small_letters(word);
        if (word == "en" || word.starts_with("en-")) return true;
    }
    return false;
}

}  // namespace

SvgStyle style_in(const SvgStyle& outer, const SvgProperties& properties, const SvgDocument& document) {
    SvgStyle style = outer;
    style.fill = paint_of(properties.find("fill"), outer.fill, document);
    style.stroke = paint_of(properties.find("stroke"), outer.stroke, document);
    style.current_colour = colour_of(properties.find("color"), outer.current_colour, outer.current_colour);
    style.fill_colour = colour_of(properties.find("fill"), outer.fill_colour, style.current_colour);
    style.fill_opacity = share_of(properties.find("fill-opacity")).value_or(outer.fill_opacity);
    style.stroke_opacity = share_of(properties.find("stroke-opacity")).value_or(outer.stroke_opacity);
    style.stroke_width = stroke_width_of(properties.find("stroke-width"), outer.stroke_width);
    style.fill_rule = rule_of(properties.find("fill-rule"), outer.fill_rule);
    style.clip_rule = rule_of(properties.find("clip-rule"), outer.clip_rule);
    style.font_size = font_size_of(properties.find("font-size"), outer.font_size);
    const std::string_view visibility = properties.find("visibility");
    if (visibility == "visible") style.visibility = SvgStyle::Visibility::Visible;
    if (visibility == "hidden" || visibility == "collapse") style.visibility = SvgStyle::Visibility::Hidden;
    return style;
}

bool is_switched_off(const SvgProperties& properties) {
    return properties.find("display") == "none" || share_of(properties.find("opacity")) == 0.0;
}

bool meets_conditions(pugi::xml_node node, const SvgDocument& document) {
    document.charge(node);  // all attributes are searched, also of an element that is not drawn
    if (const auto language = node.attribute("systemLanguage")) {
        const std::string_view list = language.value();
        document.charge(node, list.size());
        if (!names_english(list)) return false;
    }
    return !node.attribute("requiredExtensions");
}

}  // namespace fretwork::outlines::detail
