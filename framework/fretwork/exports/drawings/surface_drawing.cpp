// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/text.hpp>
#include <fretwork/exports/drawings/detail/furniture.hpp>
#include <fretwork/exports/drawings/detail/panels.hpp>
#include <fretwork/exports/drawings/detail/pattern_legend.hpp>
#include <fretwork/exports/drawings/detail/print.hpp>
#include <fretwork/exports/drawings/surface_drawing.hpp>

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

namespace fretwork::exports {
namespace {

using detail::SvgCanvas;
using simulation::Conditions;
using simulation::Surface;

std::string surface_title(const Surface& surface) {
    return "Tessellation with " + base::counted(surface.tessellation.tiles.size(), "tile") + " and " +
           base::counted(surface.tessellation.patterns.size(), "pattern");
}

/// A figure as wide as a column, in print: panels with letters, from the top down.
class Figure {
  public:
    /// Panels side by side, each with a letter above it.
    void add_row(std::vector<std::pair<std::string, SvgCanvas>> panels) {
        const double each =
            (kWidth - kGap * static_cast<double>(panels.size() - 1)) / static_cast<double>(panels.size());
        double height = 0.0;
        double left = 0.0;
        for (auto& [name, panel] : panels) {
            height = std::max(height, each * panel.box().height() / panel.box().width());
            panels_.push_back({std::move(name), std::move(panel), {left, -height_ - kLetterStep}, each});
            left += each + kGap;
        }
        height_ += height + kLetterStep;
    }
    /// The patterns' legend, which spans the figure.
    void add_legend(const Surface& surface) {
        legend_.emplace(surface, kWidth - 2.0 * kText, kText);
        legend_top_ = -height_ - kText;
        height_ += legend_->height() + 1.5 * kText;
    }
    [[nodiscard]] std::string document(std::string_view title) const {
        SvgCanvas sheet({0.0, -height_, kWidth, 0.0}, 1.0);
        sheet.print_as_wide_as(kWidth);
        char letter = 'a';
        for (const Panel& panel : panels_) {
            sheet.embed(panel.canvas, panel.top_left, panel.width, panel.name);
            sheet.text({panel.top_left.x, panel.top_left.y + 0.2 * kText}, std::string{'(', letter++, ')'},
                       kText);
        }
        if (legend_) legend_->draw(sheet, {kText, legend_top_});
        return sheet.document(title);
    }

  private:
    static constexpr double kWidth = detail::kColumnWidth;
    static constexpr double kText = detail::legible_height(kWidth, kWidth);
    static constexpr double kGap = 0.02 * kWidth;
    static constexpr double kLetterStep = 1.5 * kText;

    struct Panel {
        std::string name;
        SvgCanvas canvas;
        geometry::Point2 top_left;
        double width;
    };
    std::vector<Panel> panels_;
    std::optional<detail::PatternLegend> legend_;
    double legend_top_ = 0.0;
    double height_ = 0.0;
};

/// A drawing for a column.
std::string column_document(SvgCanvas canvas, std::string_view title) {
    canvas.print_as_wide_as(detail::kColumnWidth);
    return canvas.document(title);
}

}  // namespace

LineSet rim_lines(const Surface& surface) {
    std::map<std::pair<int, int>, int> uses;
    for (const tiling::Tile& tile : surface.tessellation.tiles) {
        for (std::size_t k = 0; k < tile.vertices.size(); ++k) {
            const int a = tile.vertices[k];
            const int b = tile.vertices[(k + 1) % tile.vertices.size()];
            ++uses[std::minmax(a, b)];
        }
    }
    LineSet rim;
    for (const geometry::Point2& vertex : surface.tessellation.vertices)
        rim.nodes.emplace_back(vertex.x, vertex.y, 0.0);
    for (const auto& [side, count] : uses) {
        if (count == 1) rim.lines.push_back({side.first, side.second});
    }
    return rim;
}

std::string surface_svg(const Surface& surface, const Conditions* conditions, const DrawnLabels& labels) {
    using Shown = DrawnLabels::Shown;
    SvgCanvas panel = detail::surface_panel(surface, conditions, labels);
    // Numbers are as small as their tiles.
    if (labels.tiles == Shown::Yes || labels.interface_nodes == Shown::Yes)
        return panel.document(surface_title(surface));
    return column_document(std::move(panel), surface_title(surface));
}

std::string deformed_svg(std::span<const DeformedLayer> layers, const DeformedViewOptions& options) {
    return column_document(detail::deformed_panel(layers, options),
                           "Deformed state, " + detail::scale_note(options.scale));
}

std::string displacement_svg(const DeformedLayer& layer, const DeformedViewOptions& options) {
    return column_document(detail::displacement_panel(layer, options),
                           "Displacements of " + layer.label + ", " + detail::scale_note(options.scale));
}

std::string figure_svg(const Surface& surface, const Conditions& conditions,
                       std::span<const DeformedLayer> layers, const DeformedViewOptions& options) {
    const bool has_reduced = !options.reduced.lines.empty();
    const double text_share = detail::text_height(has_reduced ? 2.1 : 1.0);  // two panels share the width
    Figure figure;
    std::vector<std::pair<std::string, SvgCanvas>> plans;
    plans.emplace_back("surface", detail::tiling_panel(surface, options.labels, text_share));
    if (has_reduced)
        plans.emplace_back("reduced", detail::reduced_panel(surface, options.reduced, text_share));
    figure.add_row(std::move(plans));
    figure.add_legend(surface);
    figure.add_row({{"setup", detail::setup_panel(surface, conditions, options.view)}});
    if (layers.size() == 1)
        figure.add_row({{"deformed", detail::displacement_panel(layers.front(), options)}});
    if (layers.size() > 1) figure.add_row({{"deformed", detail::deformed_panel(layers, options)}});
    return figure.document(surface_title(surface) + ": setup and deformed state");
}

}  // namespace fretwork::exports
