// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/exports/drawings/detail/fan_drawing.hpp>
#include <fretwork/exports/drawings/detail/furniture.hpp>
#include <fretwork/exports/drawings/detail/print.hpp>
#include <fretwork/exports/drawings/pattern_drawing.hpp>

#include <algorithm>
#include <utility>
#include <vector>

namespace fretwork::exports {
namespace {

using geometry::Point2;
using pattern::NodeLayout;
using pattern::Pattern;
using pattern::Rejection;

constexpr const char* kFace = "#f4f6f8";

/// The rejections in rows: successive rejections by the same filter are one row.
std::vector<std::vector<const Rejection*>> rows_by_filter(std::span<const Rejection> rejections) {
    std::vector<std::vector<const Rejection*>> rows;
    for (const Rejection& rejection : rejections) {
        if (rows.empty() || rows.back().front()->verdict.filter != rejection.verdict.filter)
            rows.emplace_back();
        rows.back().push_back(&rejection);
    }
    return rows;
}

Pattern guilty_part(const pattern::Verdict& verdict) {
    Pattern::Bits bits;
    for (const pattern::EdgeIndex edge : verdict.guilty) bits.set(edge);
    return Pattern(bits);
}

/// The rejections of one filter, with the lines below each fan: id and reason.
struct FilterRow {
    std::vector<const Rejection*> rejections;
    std::vector<std::vector<std::string>> texts;
    std::size_t most_lines = 1;
};

FilterRow make_filter_row(const NodeLayout& layout, std::vector<const Rejection*> rejections, double text,
                          double width) {
    FilterRow row{std::move(rejections), {}};
    for (const Rejection* rejection : row.rejections) {
        auto lines = detail::lines_within(pattern_id(layout, rejection->pattern), text, width);
        for (std::string& line : detail::lines_within(rejection->verdict.reason, text, width))
            lines.push_back(std::move(line));
        row.most_lines = std::max(row.most_lines, lines.size());
        row.texts.push_back(std::move(lines));
    }
    return row;
}

/// The name of a filter as words.
std::string words_of(std::string name) {
    std::ranges::replace(name, '_', ' ');
    return name;
}

/// The measures of the sheet, metres.
struct SheetMeasures {
    double side;
    double step_x;
    double text;

    [[nodiscard]] double title() const { return 2.0 * text; }
    [[nodiscard]] double height_of(const FilterRow& row) const {
        const double lines = detail::kLineStep * static_cast<double>(row.most_lines - 1);
        return title() + 1.9 * side + (2.0 + lines) * text;
    }
};

}  // namespace

std::string rejection_sheet_svg(const NodeLayout& layout, std::span<const Rejection> rejections,
                                const PatternDrawingOptions& options) {
    const auto by_filter = rows_by_filter(rejections);
    std::size_t columns = 1;
    for (const auto& row : by_filter) columns = std::max(columns, row.size());
    const double side = options.tile_side;
    const double step_x = 2.3 * side;
    const detail::SheetPrint print = detail::sheet_print(static_cast<int>(columns), step_x);
    const SheetMeasures measures{side, step_x, std::max(0.13 * side, print.text)};
    std::vector<FilterRow> rows;
    double height = 0.0;
    for (const auto& row : by_filter) {
        rows.push_back(make_filter_row(layout, row, measures.text, 0.97 * step_x));
        height += measures.height_of(rows.back());
    }
    detail::SvgCanvas canvas({0.0, -std::max(height, side), static_cast<double>(columns) * step_x, 0.0}, 1.0);
    canvas.print_as_wide_as(print.width);
    double top = 0.0;
    for (const FilterRow& row : rows) {
        canvas.text({0.05 * step_x, top - 1.4 * measures.text},
                    words_of(row.rejections.front()->verdict.filter), 1.2 * measures.text);
        const double y = top - measures.title() - 0.95 * side;
        for (std::size_t c = 0; c < row.rejections.size(); ++c) {
            const Rejection& rejection = *row.rejections[c];
            const Point2 center{(static_cast<double>(c) + 0.5) * step_x, y};
            detail::draw_fan(canvas, layout, rejection.pattern, {center, kFace}, options,
                             guilty_part(rejection.verdict));
            detail::write_lines(canvas, {center.x, y - 0.95 * side - measures.text}, row.texts[c],
                                measures.text);
        }
        top -= measures.height_of(row);
    }
    return canvas.document("Rejected patterns of layout " + layout.name());
}

}  // namespace fretwork::exports
