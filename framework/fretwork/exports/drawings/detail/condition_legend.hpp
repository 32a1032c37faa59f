// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/exports/drawings/detail/surface_parts.hpp>

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace fretwork::exports::detail {

/// What balls, arrows and rings mean, in as many lines as it takes.
class ConditionLegend {
  public:
    /// @param loads  those that are drawn: some of `conditions`, or all
    ConditionLegend(std::span<const SupportMark> supports, std::span<const LoadMark> loads,
                    const simulation::Conditions& conditions);

    /// The height of the legend in text of some height.
    [[nodiscard]] double height(double width, double text) const;
    void draw(SvgCanvas& canvas, const geometry::Point2& top_left, double width, double text) const;

  private:
    /// A ball, or an arrow or ring, or neither; and what it means.
    struct Entry {
        std::optional<SupportMark> support;
        std::optional<LoadMark> load;
        std::string words;
    };
    void add_loads(LoadMark::Kind kind, std::span<const LoadMark> drawn, std::string words);
    /// Where entries start, from the top left corner of the legend, in heights of the text.
    [[nodiscard]] std::vector<geometry::Point2> places(double width) const;

    std::vector<Entry> entries_;
};

}  // namespace fretwork::exports::detail
