// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/exports/drawings/detail/fan_drawing.hpp>
#include <fretwork/exports/drawings/pattern_drawing.hpp>

#include <algorithm>
#include <vector>

namespace fretwork::exports {
namespace {

using geometry::Point2;
using pattern::Pattern;
using pattern::Rejection;

constexpr const char* kFace = "#f4f6f8";

/// The rejections of one filter each, in their order.
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

/// One line of text as large as it can be, up to `largest`, without being wider than a column.
void caption(detail::SvgCanvas& canvas, const Point2& place, const std::string& text, double largest) {
    constexpr double kCharactersInAColumn = 52.0;
    const double height =
        std::min(largest, largest * kCharactersInAColumn / 2 / static_cast<double>(text.size() + 1));
    canvas.text(place, text, height, detail::Anchor::Middle);
}

}  // namespace

std::string rejection_sheet_svg(const pattern::NodeLayout& layout, std::span<const Rejection> rejections,
                                const PatternDrawingOptions& options) {
    const auto rows = rows_by_filter(rejections);
    std::size_t columns = 1;
    for (const auto& row : rows) columns = std::max(columns, row.size());
    const double side = options.tile_side;
    const double step_x = 2.3 * side;
    const double step_y = 2.75 * side;
    const auto height = static_cast<double>(std::max<std::size_t>(rows.size(), 1));
    detail::SvgCanvas canvas({-0.55 * step_x, -(height - 0.42) * step_y,
                              (static_cast<double>(columns) - 0.45) * step_x, 0.58 * step_y},
                             1.0);
    for (std::size_t r = 0; r < rows.size(); ++r) {
        const double y = -static_cast<double>(r) * step_y;
        canvas.text({-0.5 * step_x, y + 1.15 * side}, rows[r].front()->verdict.filter, 0.19 * side);
        for (std::size_t c = 0; c < rows[r].size(); ++c) {
            const Rejection& rejection = *rows[r][c];
            const Point2 center{static_cast<double>(c) * step_x, y};
            detail::draw_fan(canvas, layout, rejection.pattern, {center, kFace}, options,
                             guilty_part(rejection.verdict));
            caption(canvas, {center.x, y - 1.13 * side}, pattern_id(layout, rejection.pattern), 0.13 * side);
            caption(canvas, {center.x, y - 1.32 * side}, rejection.verdict.reason, 0.13 * side);
        }
    }
    return canvas.document("Rejected patterns of layout " + layout.name());
}

}  // namespace fretwork::exports
