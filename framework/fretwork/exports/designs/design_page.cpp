// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/text.hpp>
#include <fretwork/design/design_words.hpp>
#include <fretwork/exports/colours.hpp>
#include <fretwork/exports/designs/design_page.hpp>
#include <fretwork/exports/detail/design_template.hpp>
#include <fretwork/exports/pages/html_page.hpp>
#include <fretwork/simulation/results/surface_beams.hpp>
#include <fretwork/simulation/surface.hpp>

#include <algorithm>
#include <cstdint>
#include <optional>

namespace fretwork::exports {
namespace {

using base::Json;
using design::CaseShape;
using design::DesignReport;

/// Displacements of nodes, three numbers each.
std::string motion_text(const mechanics::NodeValues& rows) {
    std::vector<float> numbers;
    for (Eigen::Index node = 0; node < rows.rows(); ++node) {
        for (Eigen::Index c = 0; c < 3; ++c) numbers.push_back(static_cast<float>(rows(node, c)));
    }
    return detail::packed(numbers);
}

/// A bent shape with all of its goals. For a node with several goals, the page shows the largest distance.
Json shape_json(const CaseShape& shape, Eigen::Index nodes) {
    Json goals = Json::array();
    for (const CaseShape::GoalNode& goal : shape.goals)
        goals.push_back({goal.node, goal.wanted.x(), goal.wanted.y(), goal.wanted.z(), goal.distance});
    return {{"name", shape.load_case},
            {"motion", motion_text(shape.displacements.topRows(std::min(nodes, shape.displacements.rows())))},
            {"goals", goals}};
}

Json shapes_json(const std::vector<CaseShape>& shapes, Eigen::Index nodes) {
    Json list = Json::array();
    for (const CaseShape& shape : shapes) list.push_back(shape_json(shape, nodes));
    return list;
}

Json curvatures_json(const std::vector<design::Curvatures>& list) {
    Json json = Json::array();
    for (const design::Curvatures& own : list) json.push_back({own.largest, own.smallest});
    return json;
}

void add_surface(const simulation::Surface& surface, Json& json) {
    const simulation::SurfaceBeams beams = simulation::surface_beams(surface);
    std::vector<float> places;
    for (const Eigen::Vector3d& node : beams.nodes) {
        places.push_back(static_cast<float>(node.x()));
        places.push_back(static_cast<float>(node.y()));
    }
    std::vector<std::uint32_t> bars;
    for (std::size_t b = 0; b < beams.ends.size(); ++b) {
        for (const mechanics::NodeIndex end : beams.ends[b])
            bars.push_back(static_cast<std::uint32_t>(end.value));
        bars.push_back(static_cast<std::uint32_t>(beams.tiles[b].value));
    }
    Json tiles = Json::array();
    for (const tiling::TileIndex tile : surface.tessellation.tiles.indices()) {
        const tiling::Tile& own = surface.tessellation.tiles[tile];
        Json corners = Json::array();
        for (const geometry::Point2& corner : tiling::tile_polygon(surface.tessellation, tile))
            corners.push_back({corner.x, corner.y});
        Json nodes = Json::array();
        for (const tiling::InterfaceIndex node : own.interface_nodes) nodes.push_back(node.value);
        tiles.push_back({{"pattern", own.pattern}, {"corners", corners}, {"nodes", nodes}});
    }
    Json patterns = Json::array();
    for (std::size_t p = 0; p < surface.tessellation.patterns.size(); ++p)
        patterns.push_back(
            {{"id", surface.tessellation.patterns[p].id}, {"colour", pattern_colour(static_cast<int>(p))}});
    json["places"] = detail::packed(places);
    json["bars"] = detail::packed(bars);
    json["tiles"] = tiles;
    json["patterns"] = patterns;
    json["interface_nodes"] = beams.interface_nodes;
}

Json error_json(const std::optional<design::TargetError>& error) {
    if (!error) return nullptr;
    return {{"mean", error->mean}, {"largest", error->largest}, {"stable", error->is_stable}};
}

Json page_json(const DesignReport& report, const design::Target& target) {
    const simulation::Surface surface = simulation::make_surface(report.project, nullptr);
    const auto interface_nodes = std::ssize(surface.tessellation.interface_nodes);
    Json json = {
        {"title", target.name.empty() ? "Design" : target.name},
        {"description", target.description},
        {"error", error_json(report.error)},
        {"uniform", error_json(report.best_uniform)},
        {"uniform_pattern", report.best_uniform_pattern},
        {"uniform_tried", report.uniform_tried},
        {"uniform_solutions", report.uniform_solutions},
        {"shapes",
         shapes_json(report.shapes, report.shapes.empty() ? 0 : report.shapes.front().displacements.rows())},
        {"uniform_shapes", shapes_json(report.uniform_shapes, interface_nodes)},
        {"gamut",
         {{"reached", curvatures_json(report.gamut.reached)},
          {"wanted", curvatures_json(report.gamut.wanted)},
          {"designed", curvatures_json(report.gamut.designed)}}},
        {"limits", design_limits(report)},
        {"solutions", report.solutions},
        {"full_solutions", report.full_solutions},
        {"seconds", report.seconds},
        {"seed", report.seed},
        {"slides", report.slides}};
    Json history = Json::array();
    for (const design::DesignProgress& own : report.history)
        history.push_back({own.solutions, own.seconds, own.misfit});
    json["history"] = history;
    json["factors"] = report.factors;
    json["load_cases"] = report.load_cases;
    if (report.width) json["section"] = {*report.width, report.thickness.value_or(0.0)};
    add_surface(surface, json);
    return json;
}

std::string percent(double share) {
    return base::format_number(100.0 * share, 3) + " %";
}

std::string end_sentence(design::DesignEnd end) {
    using design::DesignEnd;
    const bool is_spent = end == DesignEnd::SolutionsSpent || end == DesignEnd::TimeSpent;
    return "The design ended: " + std::string(design::design_end_words(end)) +
           (end == DesignEnd::NoSwapImproves ? ", which is no proof that there is none"
            : is_spent                       ? ", and more may improve the painting"
                                             : "") +
           ".";
}

void add_reach(const DesignReport& report, std::vector<std::string>& lines) {
    const std::optional<double> outside = report.gamut.share_outside();
    if (outside && *outside > 0.1)
        lines.push_back("Of the tiles, " + percent(*outside) +
                        " shall take curvatures that no tile takes with any single pattern that was tried. "
                        "Other loads or moved supports reach them sooner than other patterns do.");
    if (report.bound)
        lines.push_back("In linear theory no painting of these patterns comes nearer than " +
                        percent(*report.bound) + " (root mean square).");
    if (report.nothing_moves) lines.emplace_back("Nothing moves under the load case.");
    if (report.wanted_of_softest > 1.0)
        lines.push_back("The target asks for " + base::format_number(report.wanted_of_softest, 3) +
                        " times the displacement of the softest single pattern under the given loads.");
    if (report.reach_of_ten_loads)
        lines.push_back("Ten times the load displaces the softest single pattern by " +
                        percent(*report.reach_of_ten_loads) + " of what is wanted.");
    if (report.wanted_of_stiffest > 0.0 && report.wanted_of_stiffest < 1.0)
        lines.push_back(
            "Under the given loads, the stiffest single pattern is displaced by more than is wanted.");
}

}  // namespace

std::vector<std::string> design_limits(const DesignReport& report) {
    std::vector<std::string> lines{end_sentence(report.end)};
    add_reach(report, lines);
    if (report.error && !report.error->is_stable) lines.emplace_back("The bent surface is not stable.");
    if (report.error && report.error->is_stable && !report.error->is_stable_from_flat)
        lines.emplace_back("The surface snaps on its way from flat.");
    if (report.error && report.model_error > 0.2 * report.error->mean)
        lines.push_back("The reduced model of the search is off by " + percent(report.model_error) +
                        " of the largest displacement: nearer paintings are hard to tell apart.");
    if (report.start_misfits.size() > 1) {
        const auto [least, most] = std::ranges::minmax(report.start_misfits);
        lines.push_back("The " + std::to_string(report.start_misfits.size()) +
                        " starts of the search ended with misfits from " + percent(least) + " to " +
                        percent(most) + ".");
    }
    for (const design::DesignWarning& warning : report.warnings)
        lines.push_back(design::plain_text(warning) + ".");
    return lines;
}

std::string design_html(const DesignReport& report, const design::Target& target) {
    return detail::page_with_data(design_template.front().second, page_json(report, target));
}

}  // namespace fretwork::exports
