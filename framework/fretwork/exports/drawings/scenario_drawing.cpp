// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/exports/drawings/detail/furniture.hpp>
#include <fretwork/exports/drawings/detail/surface_parts.hpp>
#include <fretwork/exports/drawings/pattern_drawing.hpp>
#include <fretwork/geometry/plane.hpp>
#include <fretwork/mechanics/discretization.hpp>
#include <fretwork/mechanics/linear_solver.hpp>
#include <fretwork/mechanics/paths/equilibrium.hpp>
#include <fretwork/reduction/calibration/model_response.hpp>
#include <fretwork/reduction/response.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

namespace fretwork::exports {
namespace {

using detail::Anchor;
using detail::Projection;
using detail::SvgCanvas;
using geometry::Point2;
using reduction::Scenario;
using simulation::Conditions;
using simulation::Surface;

constexpr const char* kFullColour = "#8a8f94";
constexpr int kDrawnDivisions = 6;  ///< of a beam: it is drawn as bent as it is

// Lengths as multiples of the tile's side.
constexpr double kCellWidth = 3.6;
constexpr double kCellHeight = 3.1;
constexpr double kReach = 0.75;  ///< of the largest arrow
constexpr double kBall = 0.09;
constexpr double kText = 0.14;

/// One tile in the setting's polygon, painted with the pattern.
Surface tile_surface(const pattern::NodeLayout& layout, const pattern::Pattern& pattern,
                     const reduction::Setting& setting) {
    const geometry::Polygon polygon = geometry::regular_polygon(setting.sides, setting.tile_side);
    const pattern::Fan fan = pattern::make_fan(layout, pattern, setting.sides);
    const auto places = pattern::place_fan(layout, fan, polygon);
    tiling::Tile tile{.vertices = {}, .interface_nodes = {}, .pattern = 0};
    for (int i = 0; i < setting.sides; ++i) tile.vertices.emplace_back(i);
    for (int i = 0; i < fan.interface_node_count; ++i) tile.interface_nodes.emplace_back(i);
    tiling::Tessellation tessellation{
        .layout = layout.name(),
        .vertices = polygon,
        .tiles = {tile},
        .interface_nodes = {places.begin(), places.begin() + fan.interface_node_count},
        .patterns = {pattern::named(layout, pattern)}};
    return {layout, std::move(tessellation), setting, {{}}};
}

Conditions conditions_of(const mechanics::Frame& loaded) {
    return {.supports = loaded.supports, .prescribed = {}, .loads = loaded.loads};
}

LineSet lines_of(const mechanics::Frame& frame, const mechanics::Solution& solution) {
    LineSet lines = frame_lines(frame);
    lines.displacements = solution.displacements;
    return lines;
}

/// A state of the full model, and the share of the largest magnitude at which it is.
struct BentTile {
    LineSet lines;
    double share = 0.0;
};

BentTile bent_tile(const mechanics::Frame& frame, const reduction::Setting& setting) {
    const std::vector<double> factors = mechanics::even_load_factors(setting.magnitudes);
    const auto solutions = mechanics::follow_load_path(mechanics::assemble(frame), factors);
    BentTile bent{frame_lines(frame)};
    for (std::size_t i = 0; i < solutions.size() && solutions[i].converged(); ++i)
        bent = {lines_of(frame, solutions[i]), factors[i]};
    return bent;
}

/// A tile under a scenario, ready to be drawn.
struct Cell {
    const Scenario* scenario;
    Conditions conditions;
    BentTile full;
    std::optional<LineSet> reduced;
};

struct Modelled {
    const ReducedPattern& reduced;
    std::span<const reduction::TileModel> models;
};

Cell make_cell(const pattern::NodeLayout& layout, const Modelled& modelled, const reduction::Setting& setting,
               const Scenario& scenario) {
    const ReducedPattern& pattern = modelled.reduced;
    const Scenario spread = spread_over_sides(scenario, static_cast<int>(layout.interface_nodes().size()));
    const mechanics::Frame frame = scenario_frame(
        mechanics::refined(pattern_frame(layout, pattern.pattern, setting), kDrawnDivisions), spread);
    Cell cell{&scenario, conditions_of(frame), bent_tile(frame, setting), std::nullopt};
    if (!pattern.calibration) return cell;
    const reduction::TileModel& model =
        reduction::find_tile_model(pattern.calibration->model, modelled.models);
    const reduction::ModelTile tile(model, layout, pattern.pattern, setting);
    const mechanics::Frame ring =
        scenario_frame(tile.parts(reduction::parameter_values(*pattern.calibration, model)).beams, spread);
    cell.reduced = lines_of(ring, mechanics::solve_linear(mechanics::assemble(ring)));
    *cell.reduced->displacements *= cell.full.share;
    return cell;
}

/// Draws cells into a sheet, each with the middle of its tile at a place.
class CellPen {
  public:
    CellPen(SvgCanvas& canvas, const Surface& surface)
        : canvas_(canvas),
          surface_(surface),
          side_(surface.setting.tile_side),
          bar_(detail::beam_width(surface)) {}

    void draw(const Cell& cell, const Point2& middle) {
        canvas_.layer(cell.scenario->name);
        const auto rim = detail::moved(projection_.all(surface_.tessellation.vertices), middle);
        canvas_.polygon(rim, {"#f4f6f8", detail::kRimColour, 0.15 * bar_, 1.0});
        draw_lines(cell.full.lines, middle, {"none", kFullColour, bar_, 1.0});
        if (cell.reduced)
            draw_lines(*cell.reduced, middle, {"none", detail::kReducedColour, 0.5 * bar_, 1.0});
        for (detail::SupportMark mark : detail::support_marks(surface_, cell.conditions, projection_)) {
            mark.place = mark.place + middle;
            draw_support(canvas_, mark, kBall * side_);
        }
        for (detail::LoadMark mark :
             detail::load_marks(surface_, cell.conditions, projection_, kReach * side_)) {
            mark.from = mark.from + middle;
            mark.to = mark.to + middle;
            draw_load(canvas_, mark);
        }
        write_caption(cell, {middle.x, middle.y - (0.5 * kCellHeight - 2.5 * kText) * side_});
    }

  private:
    void draw_lines(const LineSet& lines, const Point2& middle, const detail::Style& style) {
        const auto places = detail::moved(projection_.all(displaced_nodes(lines, 1.0)), middle);
        canvas_.segments(detail::segments_of(lines.lines, places), style);
    }

    void write_caption(const Cell& cell, const Point2& place) {
        const double text = kText * side_;
        const double magnitude = cell.full.share * cell.scenario->max_magnitude;
        canvas_.text(place, cell.scenario->name + " under " + detail::short_number(magnitude) + " N", text,
                     Anchor::Middle);
        canvas_.text({place.x, place.y - 1.5 * text},
                     "moves by " + detail::millimetres(largest(cell.full.lines)) +
                         (cell.reduced ? ", reduced " + detail::millimetres(largest(*cell.reduced)) : ""),
                     text, Anchor::Middle);
    }

    static double largest(const LineSet& lines) {
        return lines.displacements ? lines.displacements->leftCols<3>().rowwise().norm().maxCoeff() : 0.0;
    }

    SvgCanvas& canvas_;
    const Surface& surface_;
    Projection projection_{ViewOptions{}};
    double side_;
    double bar_;
};

}  // namespace

std::string scenario_sheet_svg(const pattern::NodeLayout& layout, const ReducedPattern& pattern,
                               const reduction::Setting& setting,
                               std::span<const reduction::TileModel> models) {
    const Surface surface = tile_surface(layout, pattern.pattern, setting);
    const double width = kCellWidth * setting.tile_side;
    const double height = kCellHeight * setting.tile_side;
    const auto count = static_cast<double>(setting.scenarios.size());
    SvgCanvas canvas({-0.5 * width, -0.5 * height, (count - 0.5) * width, 0.5 * height}, 1.0);
    CellPen pen(canvas, surface);
    for (std::size_t i = 0; i < setting.scenarios.size(); ++i)
        pen.draw(make_cell(layout, {pattern, models}, setting, setting.scenarios[i]),
                 {static_cast<double>(i) * width, 0.2 * setting.tile_side});
    return canvas.document("The scenarios on " + pattern_id(layout, pattern.pattern));
}

}  // namespace fretwork::exports
