// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/exports/drawings/detail/svg_canvas.hpp>
#include <fretwork/simulation/surface.hpp>

#include <string>
#include <vector>

namespace fretwork::exports::detail {

/// The legend of the patterns that a surface uses: for each, a small fan on its colour, and its id. Up to six
/// fans have their ids beside them. More fans have letters, and a list below gives the id of each letter.
class PatternLegend {
  public:
    /// @param width  of the legend, metres
    /// @param text   the height of its text, metres
    PatternLegend(const simulation::Surface& surface, double width, double text);

    [[nodiscard]] double height() const;
    void draw(SvgCanvas& canvas, const geometry::Point2& top_left) const;

  private:
    /// A text in the list of ids, at a place from the top left corner of the legend.
    struct ListedText {
        geometry::Point2 place;
        std::string words;
    };
    void place_beside();
    void place_in_list();
    void draw_icon(SvgCanvas& canvas, std::size_t pattern, const geometry::Point2& middle) const;

    const simulation::Surface* surface_;
    std::vector<std::size_t> used_;
    double width_;
    double text_;
    std::vector<geometry::Point2> icons_;  // their middles, from the top left corner
    std::vector<ListedText> texts_;
    double height_ = 0.0;
};

/// A, B, .. Z, AA, AB ..
std::string key_letters(std::size_t index);

}  // namespace fretwork::exports::detail
