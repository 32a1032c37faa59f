// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/exports/colours.hpp>
#include <fretwork/exports/drawings/detail/fan_drawing.hpp>
#include <fretwork/exports/drawings/detail/furniture.hpp>
#include <fretwork/exports/drawings/detail/pattern_legend.hpp>
#include <fretwork/tiling/tessellation.hpp>

#include <algorithm>

namespace fretwork::exports::detail {
namespace {

using geometry::Point2;

constexpr std::size_t kMostBeside = 6;  ///< patterns with their ids beside them

// In heights of the text.
constexpr double kIconSide = 1.5;
constexpr double kIconWidth = 2.0 * kIconSide;
constexpr double kIconStep = 3.1;    ///< from row to row
constexpr double kIdWidth = 10.5;    ///< beside an icon: four edges
constexpr double kIdGap = 1.2;       ///< between ids in the list
constexpr double kIdAfterKey = 0.4;  ///< from a letter to its id

/// Cells of one size below each other and side by side, each with an icon at its left.
struct IconGrid {
    [[nodiscard]] Point2 icon(std::size_t index, double icon_width) const {
        const std::size_t row = index / columns;
        return {static_cast<double>(index % columns) * cell_width + 0.5 * icon_width,
                -(static_cast<double>(row) + 0.5) * cell_height};
    }
    [[nodiscard]] double height(std::size_t cells) const {
        const std::size_t rows = (cells + columns - 1) / columns;
        return static_cast<double>(rows) * cell_height;
    }

    std::size_t columns;
    double cell_width;
    double cell_height;
};

/// The grid with as many columns as fit, at least one.
IconGrid grid_within(double width, double cell_width, double cell_height) {
    return {static_cast<std::size_t>(std::max(1.0, width / cell_width)), cell_width, cell_height};
}

}  // namespace

std::string key_letters(std::size_t index) {
    std::string letters;
    for (std::size_t rest = index + 1; rest > 0; rest = (rest - 1) / 26)
        letters.insert(letters.begin(), static_cast<char>('A' + (rest - 1) % 26));
    return letters;
}

PatternLegend::PatternLegend(const simulation::Surface& surface, double width, double text)
    : surface_(&surface), used_(tiling::used_patterns(surface.tessellation)), width_(width), text_(text) {
    if (used_.size() <= kMostBeside) {
        place_beside();
    } else {
        place_in_list();
    }
}

double PatternLegend::height() const {
    return height_;
}

void PatternLegend::place_beside() {
    std::vector<std::vector<std::string>> ids;
    std::size_t most_lines = 1;
    double widest = 0.0;
    for (const std::size_t pattern : used_) {
        ids.push_back(lines_within(surface_->tessellation.patterns[pattern].id, 1.0, kIdWidth));
        most_lines = std::max(most_lines, ids.back().size());
        for (const std::string& line : ids.back()) widest = std::max(widest, text_width(line, 1.0));
    }
    const double row = text_ * std::max(kIconStep, kLineStep * static_cast<double>(most_lines) + 0.4);
    const IconGrid grid = grid_within(width_, text_ * (kIconWidth + 0.6 + widest + 1.0), row);
    for (std::size_t i = 0; i < ids.size(); ++i) {
        const Point2 middle = grid.icon(i, kIconWidth * text_);
        icons_.push_back(middle);
        const double lines = static_cast<double>(ids[i].size() - 1);
        Point2 place{middle.x + (0.5 * kIconWidth + 0.6) * text_,
                     middle.y + (0.5 * kLineStep * lines - 0.35) * text_};
        for (const std::string& line : ids[i]) {
            texts_.push_back({place, line});
            place.y -= kLineStep * text_;
        }
    }
    height_ = grid.height(ids.size());
}

void PatternLegend::place_in_list() {
    double key = 0.0;
    for (std::size_t i = 0; i < used_.size(); ++i) key = std::max(key, text_width(key_letters(i), 1.0));
    const IconGrid grid = grid_within(width_, text_ * (kIconWidth + 0.3 + key + 0.2), kIconStep * text_);
    for (std::size_t i = 0; i < used_.size(); ++i) {
        const Point2 middle = grid.icon(i, kIconWidth * text_);
        icons_.push_back(middle);
        texts_.push_back(
            {{middle.x + (0.5 * kIconWidth + 0.3) * text_, middle.y - 0.35 * text_}, key_letters(i)});
    }
    Point2 place{0.0, -grid.height(used_.size()) - 1.4 * text_};
    const double indent = (key + kIdAfterKey) * text_;
    for (std::size_t i = 0; i < used_.size(); ++i) {
        const std::string& id = surface_->tessellation.patterns[used_[i]].id;
        if (place.x > 0.0 && place.x + indent + text_width(id, text_) > width_)
            place = {0.0, place.y - kLineStep * text_};
        texts_.push_back({place, key_letters(i)});
        const auto lines = lines_within(id, text_, width_ - indent);
        for (const std::string& line : lines) {
            if (&line != lines.data()) place.y -= kLineStep * text_;
            texts_.push_back({{place.x + indent, place.y}, line});
        }
        place.x += indent + text_width(lines.back(), text_) + kIdGap * text_;
    }
    height_ = 0.5 * text_ - place.y;
}

void PatternLegend::draw(SvgCanvas& canvas, const Point2& top_left) const {
    canvas.layer("legend of patterns");
    const auto at = [&](const Point2& place) { return Point2{top_left.x + place.x, top_left.y + place.y}; };
    for (std::size_t i = 0; i < icons_.size(); ++i) draw_icon(canvas, used_[i], at(icons_[i]));
    for (const ListedText& text : texts_) canvas.text(at(text.place), text.words, text_);
}

void PatternLegend::draw_icon(SvgCanvas& canvas, std::size_t pattern, const Point2& middle) const {
    const double side = kIconSide * text_;
    const geometry::Polygon hexagon = moved(geometry::regular_polygon(6, side), middle);
    canvas.polygon(hexagon, {pattern_colour(static_cast<int>(pattern)), "none", 0.0, 1.0});
    draw_fan_beams(canvas, surface_->layout, surface_->tessellation.patterns[pattern].pattern, hexagon,
                   {"none", kBeamColour, 0.06 * side, 1.0});
}

}  // namespace fretwork::exports::detail
