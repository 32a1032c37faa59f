// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/geometry/box.hpp>
#include <fretwork/geometry/plane.hpp>

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace fretwork::exports::detail {

/// A colour as SVG writes it: "#1b9e77", or "none".
using Colour = std::string;

/// The smallest box around some points, none or more, wider by `margin` on every side.
geometry::Box bounding_box(std::span<const geometry::Point2> points, double margin);

/// The points, each with `by` added.
std::vector<geometry::Point2> moved(std::vector<geometry::Point2> points, const geometry::Point2& by);

/// Lines by their two ends.
using Segments = std::vector<geometry::Segment>;
/// The lines between points; each line has the numbers of its two ends.
template <class Ends>
Segments segments_of(const std::vector<Ends>& lines, std::span<const geometry::Point2> points) {
    Segments segments;
    for (const auto& [first, second] : lines) segments.push_back({points[first], points[second]});
    return segments;
}

/// The style of a shape. Widths are in metres.
struct Style {
    Colour fill = "none";
    Colour stroke = "none";
    double stroke_width = 0.0;
    double opacity = 1.0;
    double dash = 0.0;  ///< length of dashes and gaps, metres; 0: none
};

enum class Anchor { Start, Middle, End };

/// An SVG drawing. Coordinates are metres with y up; the picture is in millimetres, `scale` times as large as
/// the subject.
class SvgCanvas {
  public:
    SvgCanvas(const geometry::Box& box, double scale);

    /// Begins a layer of this name, which drawing programs show; the layer ends where the next begins.
    void layer(std::string_view name);
    /// Put another drawing with its top left corner at a place, `width` wide. All its ids get `name` in
    /// front, so that they stay apart.
    void embed(const SvgCanvas& drawing, const geometry::Point2& top_left, double width,
               std::string_view name);
    /// State in the document the width, m, at which the drawing is to be printed so that its text is legible.
    void print_as_wide_as(double width) { print_width_ = width; }

    void polygon(std::span<const geometry::Point2> points, const Style& style);
    /// The same with a name that shows where a pointer rests on it, and an id for programs.
    void named_polygon(std::span<const geometry::Point2> points, const Style& style, std::string_view id,
                       std::string_view name);
    /// Several open lines as one path, with round ends.
    void segments(std::span<const geometry::Segment> lines, const Style& style);
    /// The same with an id for programs.
    void named_segments(std::span<const geometry::Segment> lines, const Style& style, std::string_view id);
    void circle(const geometry::Point2& center, double radius, const Style& style);
    /// A circle that is shaded as a ball.
    void ball(const geometry::Point2& center, double radius, const Colour& colour);
    /// An arrow from `from` to `to`. Its head has the length `head`, but is no longer than the arrow.
    void arrow(const geometry::Point2& from, const geometry::Point2& to, double head, const Style& style);
    /// One line of text of a given height; `text` may hold any characters.
    void text(const geometry::Point2& place, std::string_view text, double height,
              Anchor anchor = Anchor::Start);

    /// The whole document.
    [[nodiscard]] std::string document(std::string_view title) const;
    [[nodiscard]] const geometry::Box& box() const { return box_; }

  private:
    [[nodiscard]] std::string place(const geometry::Point2& point) const;
    [[nodiscard]] std::string length(double metres) const;
    [[nodiscard]] std::string attributes(const Style& style) const;
    /// The size as attributes, with a unit behind the numbers, `factor` times as large as the view box.
    [[nodiscard]] std::string size(std::string_view unit, double factor) const;
    /// The shapes with the last layer closed.
    [[nodiscard]] std::string body() const;

    geometry::Box box_;
    double units_per_metre_;
    std::string body_;
    bool in_layer_ = false;
    double print_width_ = 0.0;  // 0: not said
};

}  // namespace fretwork::exports::detail
