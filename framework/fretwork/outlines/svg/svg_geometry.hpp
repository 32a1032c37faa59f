// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/outlines/detail/bezier.hpp>
#include <fretwork/outlines/svg/svg_document.hpp>
#include <fretwork/outlines/svg/svg_text.hpp>

#include <optional>

namespace fretwork::outlines::detail {

/// The reference lengths, in pixels, of percentages and relative units.
struct SvgMeasure {
    double width = 0.0;   ///< width of the viewport
    double height = 0.0;  ///< height of the viewport
    double font_size = 16.0;
};

/// One element, with functions that read its lengths and curves. They throw InputError with file and place if
/// a value is malformed.
class SvgElement {
  public:
    SvgElement(pugi::xml_node node, const SvgProperties& properties, const SvgDocument& document)
        : node_(node), properties_(properties), document_(document) {}

    enum class Axis { X, Y, Both };
    /// A length in pixels; `missing` if the element does not state it, or states "auto".
    [[nodiscard]] double length_or(std::string_view name, Axis axis, const SvgMeasure& measure,
                                   double missing) const;
    /// A length that must not be below zero, in pixels; `missing` as for length_or().
    [[nodiscard]] double size_or(std::string_view name, Axis axis, const SvgMeasure& measure,
                                 double missing) const;
    /// The four numbers of `viewBox`, if the element has one. Throws InputError if there are not four
    /// numbers, or if a size is below zero.
    [[nodiscard]] std::optional<std::array<double, 4>> view_box() const;
    /// The curves of a shape (path, polygon, polyline, rect, circle, ellipse, line); empty for a rect, circle
    /// or ellipse of size zero.
    [[nodiscard]] std::vector<Subpath> subpaths(std::string_view shape, const SvgMeasure& measure) const;
    /// The map that `transform` and `transform-origin` state.
    [[nodiscard]] Affine transform(const SvgMeasure& measure) const;

    [[nodiscard]] pugi::xml_node node() const { return node_; }
    [[nodiscard]] const SvgProperties& properties() const { return properties_; }

  private:
    [[nodiscard]] std::vector<Subpath> polyline() const;
    [[nodiscard]] std::vector<Subpath> rectangle(const SvgMeasure& measure) const;
    [[nodiscard]] std::vector<Subpath> ellipse(std::string_view shape, const SvgMeasure& measure) const;

    pugi::xml_node node_;
    const SvgProperties& properties_;
    const SvgDocument& document_;
};

/// A rectangle in pixels.
struct SvgBox {
    double x = 0.0;
    double y = 0.0;
    double width = 0.0;
    double height = 0.0;
    [[nodiscard]] Subpath outline() const;
};

/// The map from a viewBox to the box that shows it, by `preserveAspectRatio`.
Affine map_of_view_box(const std::array<double, 4>& view_box, const SvgBox& shown,
                       std::string_view preserve_aspect_ratio);

}  // namespace fretwork::outlines::detail
