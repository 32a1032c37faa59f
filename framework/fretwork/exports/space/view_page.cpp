// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/files/base64.hpp>
#include <fretwork/base/internal/json_text.hpp>
#include <fretwork/exports/colours.hpp>
#include <fretwork/exports/detail/view_template.hpp>
#include <fretwork/exports/drawings/detail/furniture.hpp>
#include <fretwork/exports/drawings/detail/panels.hpp>
#include <fretwork/exports/drawings/surface_drawing.hpp>
#include <fretwork/exports/space/detail/camera.hpp>
#include <fretwork/exports/space/pictures.hpp>
#include <fretwork/exports/tables/line_set.hpp>

#include <bit>
#include <cmath>
#include <cstdint>

namespace fretwork::exports {
namespace {

using base::Json;

static_assert(std::endian::native == std::endian::little, "numbers are written as they lie in memory");

template <class Number>
std::string packed(const std::vector<Number>& numbers) {
    return base::encode_base64(
        {reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(Number)});
}

void add_point(std::vector<float>& numbers, const Eigen::Vector3d& point) {
    for (const double coordinate : point) numbers.push_back(static_cast<float>(coordinate));
}

std::string packed_rim(const simulation::Surface& surface) {
    const LineSet rim = rim_lines(surface);
    std::vector<float> points;
    for (const auto& line : rim.lines) {
        for (const int node : line) add_point(points, rim.nodes[node]);
    }
    return packed(points);
}

/// In 16 bits from the lowest to the highest: finer than a screen's colours.
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
                 {"from", shown.from},     {"to", shown.to},       {"values", packed(steps)}};
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
        {"place", packed(place)},
        {"motion", packed(motion)},
        {"ends", packed(ends)},
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

/// JSON that may stand inside of an HTML page, where "</script>" would end it.
std::string text_in_page(const Json& json) {
    std::string text;
    for (const char c : json.dump(-1, ' ', false, Json::error_handler_t::replace)) {
        if (c == '<')
            text += "\\u003c";
        else
            text += c;
    }
    return text;
}

}  // namespace

std::string view_html(const Scene& scene) {
    const std::string_view page = view_template.front().second;
    const std::string_view mark = "@DATA@";
    const std::size_t at = page.find(mark);
    return std::string(page.substr(0, at)) + text_in_page(scene_json(scene)) +
           std::string(page.substr(at + mark.size()));
}

}  // namespace fretwork::exports
