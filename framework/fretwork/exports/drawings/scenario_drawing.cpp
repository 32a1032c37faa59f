// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/exports/drawings/detail/furniture.hpp>
#include <fretwork/exports/drawings/detail/print.hpp>
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

using detail::Projection;
using detail::SvgCanvas;
using geometry::Point2;
using reduction::Scenario;
using simulation::Conditions;
using simulation::Surface;

constexpr const char* kFullColour = "#8a8f94";
constexpr int kDrawnDivisions = 6;  ///< pieces of a beam, which show its bending

// Lengths as multiples of the tile's side.
constexpr int kColumns = 3;
constexpr double kCellWidth = 3.6;
constexpr double kPictureHeight = 2.0;  ///< height of a cell without its text
constexpr double kMiddle = 1.15;        ///< depth of the tile's middle below the upper end of its cell
constexpr double kReach = 0.7;          ///< length of the largest arrow
constexpr double kBall = 0.09;

/// The sheet is as wide as a journal's column.
constexpr double kText = detail::legible_height(kColumns * kCellWidth, detail::kColumnWidth);

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

double largest_movement(const LineSet& lines) {
    return lines.displacements ? lines.displacements->leftCols<3>().rowwise().norm().maxCoeff() : 0.0;
}

/// The lines below a cell.
std::vector<std::string> caption_of(const Cell& cell) {
    const double magnitude = cell.full.share * cell.scenario->max_magnitude;
    auto lines = detail::lines_within(
        cell.scenario->name + " under " + detail::short_number(magnitude) + " N", kText, 0.98 * kCellWidth);
    lines.push_back("moves by " + detail::millimetres(largest_movement(cell.full.lines)));
    if (cell.reduced) lines.push_back("reduced: " + detail::millimetres(largest_movement(*cell.reduced)));
    return lines;
}

/// The meaning in words that fit a cell.
std::string short_meaning(const detail::SupportMark& mark) {
    if (mark.meaning == "all components held") return "held";
    return mark.meaning == "displacements held" ? "pinned" : "held in part";
}

/// The key of the sheet: colours of models, supports and loads. Each row is a symbol and what it means.
class SheetKey {
  public:
    /// Collects the kinds of supports and loads that the cells show.
    SheetKey(const Surface& surface, std::span<const Cell> cells) {
        const Projection projection{ViewOptions{}};
        for (const Cell& cell : cells) {
            for (const detail::SupportMark& mark :
                 detail::support_marks(surface, cell.conditions, projection)) {
                if (std::ranges::find(supports_, mark.meaning, &detail::SupportMark::meaning) ==
                    supports_.end())
                    supports_.push_back(mark);
            }
            for (const detail::LoadMark& mark :
                 detail::load_marks(surface, cell.conditions, projection, 1.0)) {
                if (std::ranges::find(loads_, mark.kind, &detail::LoadMark::kind) == loads_.end())
                    loads_.push_back(mark);
            }
            has_reduced_ = has_reduced_ || cell.reduced;
        }
    }

    void draw(SvgCanvas& canvas, const Point2& top_left, double text, double bar) const {
        canvas.layer("key");
        Point2 place{top_left.x, top_left.y - text};
        const auto next = [&](const std::string& words) {
            canvas.text({place.x + 2.6 * text, place.y}, words, text);
            place.y -= 1.6 * text;
        };
        const auto sample = [&](const char* colour, double width) {
            const double y = place.y + 0.35 * text;
            const std::array<std::array<Point2, 2>, 1> line = {
                {{Point2{place.x, y}, Point2{place.x + 2.0 * text, y}}}};
            canvas.segments(line, {"none", colour, width, 1.0});
        };
        sample(kFullColour, bar);
        next("full model");
        if (has_reduced_) {
            sample(detail::kReducedColour, 0.5 * bar);
            next("reduced model");
        }
        for (detail::SupportMark mark : supports_) {
            mark.place = {place.x + text, place.y + 0.35 * text};
            draw_support(canvas, mark, 0.5 * text);
            next(short_meaning(mark));
        }
        for (const detail::LoadMark& mark : loads_) {
            const double y = place.y + 0.35 * text;
            draw_load(canvas, {mark.kind,
                               detail::LoadMark::Shape::Arrow,
                               {place.x, y},
                               {place.x + 2.2 * text, y},
                               2.2 * text});
            next(mark.kind == detail::LoadMark::Kind::Force ? "force" : "moment");
        }
    }

  private:
    std::vector<detail::SupportMark> supports_;
    std::vector<detail::LoadMark> loads_;
    bool has_reduced_ = false;
};

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
        detail::write_lines(canvas_, {middle.x, middle.y + (kMiddle - kPictureHeight - kText) * side_},
                            caption_of(cell), kText * side_);
    }

  private:
    void draw_lines(const LineSet& lines, const Point2& middle, const detail::Style& style) {
        const auto places = detail::moved(projection_.all(displaced_nodes(lines, 1.0)), middle);
        canvas_.segments(detail::segments_of(lines.lines, places), style);
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
    const double side = setting.tile_side;
    const double width = kCellWidth * side;
    std::vector<Cell> cells;
    std::size_t most_lines = 1;
    for (const Scenario& scenario : setting.scenarios) {
        cells.push_back(make_cell(layout, {pattern, models}, setting, scenario));
        most_lines = std::max(most_lines, caption_of(cells.back()).size());
    }
    const double height =
        (kPictureHeight + (detail::kLineStep * static_cast<double>(most_lines) + 0.6) * kText) * side;
    const auto count = static_cast<int>(cells.size());
    const int rows = count / kColumns + 1;  // the key is in the cell behind the last
    SvgCanvas canvas({0.0, -rows * height, kColumns * width, 0.0}, 1.0);
    canvas.print_as_wide_as(detail::kColumnWidth);
    CellPen pen(canvas, surface);
    for (int i = 0; i < count; ++i) {
        const int row = i / kColumns;
        pen.draw(cells[i], {(i % kColumns + 0.5) * width, -row * height - kMiddle * side});
    }
    SheetKey(surface, cells)
        .draw(canvas, {(count % kColumns + 0.12) * width, -(rows - 1) * height - 0.4 * side}, kText * side,
              detail::beam_width(surface));
    return canvas.document("The scenarios on " + pattern_id(layout, pattern.pattern));
}

}  // namespace fretwork::exports
