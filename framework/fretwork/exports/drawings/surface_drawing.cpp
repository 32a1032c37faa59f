// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/text.hpp>
#include <fretwork/exports/drawings/detail/panels.hpp>
#include <fretwork/exports/drawings/surface_drawing.hpp>

#include <algorithm>
#include <map>
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

struct NamedPanel {
    std::string name;
    SvgCanvas canvas;
};

/// Panels below each other, each in the middle.
SvgCanvas stacked(std::span<const NamedPanel> panels) {
    geometry::Box box;
    for (const NamedPanel& panel : panels) {
        box.xmax = std::max(box.xmax, panel.canvas.box().width());
        box.ymin -= panel.canvas.box().height();
    }
    SvgCanvas sheet(box, 1.0);
    double top = 0.0;
    for (const NamedPanel& panel : panels) {
        const geometry::Box& size = panel.canvas.box();
        sheet.embed(panel.canvas, {0.5 * (box.xmax - size.width()), top}, panel.name);
        top -= size.height();
    }
    return sheet;
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
    return detail::surface_panel(surface, conditions, labels).document(surface_title(surface));
}

std::string deformed_svg(std::span<const DeformedLayer> layers, const DeformedViewOptions& options) {
    return detail::deformed_panel(layers, options)
        .document("Deformed state, " + detail::scale_note(options.scale));
}

std::string displacement_svg(const DeformedLayer& layer, const DeformedViewOptions& options) {
    return detail::displacement_panel(layer, options)
        .document("Displacements of " + layer.label + ", " + detail::scale_note(options.scale));
}

std::string figure_svg(const Surface& surface, const Conditions& conditions,
                       std::span<const DeformedLayer> layers, const DeformedViewOptions& options) {
    std::vector<NamedPanel> panels = {{"surface", detail::surface_panel(surface, nullptr, options.labels)}};
    if (!options.reduced.lines.empty())
        panels.push_back({"reduced", detail::reduced_panel(surface, options.reduced)});
    panels.push_back({"setup", detail::setup_panel(surface, conditions, options.view)});
    if (layers.size() == 1)
        panels.push_back({"deformed", detail::displacement_panel(layers.front(), options)});
    if (layers.size() > 1) panels.push_back({"deformed", detail::deformed_panel(layers, options)});
    return stacked(panels).document(surface_title(surface) + ": setup and deformed state");
}

}  // namespace fretwork::exports
