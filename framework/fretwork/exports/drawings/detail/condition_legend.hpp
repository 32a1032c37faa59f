// SPDX-License-Identifier: GPL-3.0-or-later
// The legend of supports and loads.
#pragma once

#include <fretwork/exports/drawings/detail/surface_parts.hpp>

#include <string>
#include <variant>
#include <vector>

namespace fretwork::exports::detail {

/// The marks of a load case that are drawn. There may be fewer marks than loads.
struct ConditionMarks {
    std::vector<SupportMark> supports;
    std::vector<geometry::Point2> prescribed;
    std::vector<LoadMark> loads;
};

/// The legend of a load case below a drawing: each kind of mark that is drawn, with its meaning and the
/// largest value of all loads. The legend has as many lines as the drawing's width needs. If only some loads
/// are drawn, it states how many.
class ConditionLegend {
  public:
    /// @param conditions  null: there is no legend
    /// @param width       of the drawing, metres
    ConditionLegend(const ConditionMarks& marks, const simulation::Conditions* conditions, double width);

    /// The height of all lines; 0 without conditions.
    [[nodiscard]] double height() const;
    /// Draw it in a layer of its own.
    /// @param start  the start of the text of the first line
    void draw(SvgCanvas& canvas, const geometry::Point2& start) const;

  private:
    struct Prescribed {};
    struct Words {};
    /// A mark, or none, with what it means.
    struct Entry {
        std::variant<SupportMark, Prescribed, LoadMark, Words> mark;
        std::string words;
        double mark_width = 0.0;  ///< as multiples of the text's height
        int line = 0;
        double x = 0.0;  ///< from the start of the line
    };

    void add_supports(const ConditionMarks& marks);
    void add_prescribed(const simulation::Conditions& conditions);
    void add_loads(const ConditionMarks& marks, const simulation::Conditions& conditions);
    void add_load_kind(const ConditionMarks& marks, LoadMark::Kind kind, std::string words);
    void place_entries(double width);
    void draw_mark(SvgCanvas& canvas, const Entry& entry, const geometry::Point2& place) const;

    double text_;  ///< height of the text, metres
    std::vector<Entry> entries_;
    int lines_ = 0;
};

}  // namespace fretwork::exports::detail
