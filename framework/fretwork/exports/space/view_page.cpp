// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/exports/colours.hpp>
#include <fretwork/exports/detail/view_template.hpp>
#include <fretwork/exports/drawings/detail/furniture.hpp>
#include <fretwork/exports/drawings/detail/panels.hpp>
#include <fretwork/exports/drawings/surface_drawing.hpp>
#include <fretwork/exports/pages/html_page.hpp>
#include <fretwork/exports/space/detail/camera.hpp>
#include <fretwork/exports/space/pictures.hpp>
#include <fretwork/exports/tables/line_set.hpp>

#include <cmath>
#include <cstdint>

namespace fretwork::exports {
namespace {

using base::Json;

void add_point(std::vector<float>& numbers, const Eigen::Vector3d& point) {
    for (const double coordinate : point) numbers.push_back(static_cast<float>(coordinate));
}

std::string packed_rim(const simulation::Surface& surface) {
    const LineSet rim = rim_lines(surface);
    std::vector<float> points;
    for (const auto& line : rim.lines) {
        for (const int node : line) add_point(points, rim.nodes[node]);
    }
    return detail::packed(points);
}

/// Values have 16 bits, from the lowest to the highest. This is finer than a screen's colours.
Json field_json(const BarScene::Field& field) {
    constexpr std::uint16_t kUnknown = 65535;
    constexpr double kSteps = 65534.0;
    const ValueRange all = whole_range(field.values);
    const ValueRange shown = value_range(field.values);
    const double span = all.to > all.from ? all.to - all.from : 1.0;
    std::vector<std::uint16_t> steps;
    steps.reserve(field.values.size());
    for (const double value : field.values)
        steps.push_back(std::isnan(value)
                            ? kUnknown
                            : static_cast<std::uint16_t>(std::lround((value - all.from) / span * kSteps)));
    Json json = {{"name", field.name},     {"title", field.title}, {"unit", field.unit},
                 {"factor", field.factor}, {"low", all.from},      {"high", all.from + span},
                 {"from", shown.from},     {"to", shown.to},       {"values", detail::packed(steps)}};
    if (const auto beyond = largest_beyond(field.values, shown)) json["beyond"] = *beyond;
    return json;
}

Json scene_json(const Scene& scene) {
    const BarScene bars = make_bar_scene(scene);
    std::vector<float> place;
    for (const Eigen::Vector3d& node : bars.nodes) add_point(place, node);
    std::vector<float> motion;
    for (const double value : bars.motion.reshaped<Eigen::RowMajor>())
        motion.push_back(static_cast<float>(value));
    std::vector<std::uint32_t> ends;
    for (const auto& bar : bars.bars) {
        for (const int node : bar) ends.push_back(static_cast<std::uint32_t>(node));
    }
    const ViewOptions view = detail::start_view(bars, scene);
    Json json = {
        {"title", bars.title},
        {"subtitle", std::to_string(bars.bars.size()) + " bars of " + detail::millimetres(bars.width) +
                         " x " + detail::millimetres(bars.height) + ", " + detail::joints_note(bars.joints)},
        {"place", detail::packed(place)},
        {"motion", detail::packed(motion)},
        {"ends", detail::packed(ends)},
        {"rim", packed_rim(scene.surface)},
        {"width", bars.width},
        {"height", bars.height},
        {"scale", scene.displacement_scale},
        {"view", {view.azimuth, view.elevation}},
        {"colour", scene.picture.colour},
        {"beyond", kBeyondColour},
        {"scales", {scale_samples(), signed_samples()}},
        {"fields", Json::array()},
        {"supports", Json::array()},
        {"loads", Json::array()}};
    for (const BarScene::Field& field : bars.fields) json["fields"].push_back(field_json(field));
    for (const BarScene::Support& support : bars.supports)
        json["supports"].push_back({support.node, static_cast<int>(support.kind)});
    for (const BarScene::Load& load : bars.loads) {
        const auto& [node, force, moment] = load;
        json["loads"].push_back({node, force[0], force[1], force[2], moment[0], moment[1], moment[2]});
    }
    return json;
}

}  // namespace

std::string view_html(const Scene& scene) {
    return detail::page_with_data(view_template.front().second, scene_json(scene));
}

}  // namespace fretwork::exports
