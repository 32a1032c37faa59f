// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/task.hpp>
#include <fretwork/mechanics/discretization.hpp>
#include <fretwork/mechanics/paths/equilibrium.hpp>
#include <fretwork/pattern/fan.hpp>
#include <fretwork/reduction/detail/scenario_loads.hpp>
#include <fretwork/reduction/response.hpp>
#include <fretwork/reduction/scenarios/joints.hpp>

namespace fretwork::reduction {
namespace {

Response::Sample to_sample(const mechanics::Solution& solution, int interface_nodes) {
    Response::Sample sample;
    sample.converged = solution.converged();
    sample.stable = solution.is_stable_equilibrium();
    sample.limit_load = solution.termination == mechanics::Termination::LimitLoad;
    sample.displacements = mechanics::NodeValues::Zero(interface_nodes, mechanics::kDofsPerNode);
    if (sample.converged) sample.displacements = solution.displacements.topRows(interface_nodes);
    return sample;
}

/// The response that has these solutions, one for each magnitude.
Response to_response(std::span<const mechanics::Solution> solutions, const Scenario& scenario,
                     int interface_nodes) {
    const std::vector<double> factors = mechanics::even_load_factors(static_cast<int>(solutions.size()));
    Response response;
    response.scenario = scenario.name;
    for (std::size_t i = 0; i < solutions.size(); ++i) {
        Response::Sample sample = to_sample(solutions[i], interface_nodes);
        sample.step = static_cast<int>(i) + 1;
        sample.magnitude = factors[i] * scenario.max_magnitude;
        response.samples.push_back(std::move(sample));
    }
    return response;
}

/// The frame of a tile without supports and loads.
struct FreeTile {
    mechanics::Frame frame;
    int interface_nodes = 0;
    int magnitudes = 0;
};

Response respond(const FreeTile& tile, const Scenario& scenario, const ResponseOptions& options) {
    const mechanics::Frame frame = scenario_frame(tile.frame, scenario);
    const std::vector<double> factors = mechanics::even_load_factors(tile.magnitudes);
    const mechanics::EquilibriumOptions path_options{.control = options.control.silent()};
    const auto solutions = mechanics::follow_load_path(mechanics::assemble(frame), factors, path_options);
    Response response = to_response(solutions, scenario, tile.interface_nodes);
    if (!options.estimate_error) return response;
    const auto errors = mechanics::estimate_discretization_error(frame, factors, solutions, path_options);
    for (std::size_t i = 0; i < errors.size(); ++i) {
        if (errors[i].known) response.samples[i].discretization_error = errors[i].share;
    }
    return response;
}

}  // namespace

mechanics::Frame fan_frame(const pattern::NodeLayout& layout, const pattern::Fan& fan,
                           const geometry::Polygon& polygon, const TileMaterial& bars) {
    mechanics::Frame frame;
    for (const geometry::Point2& point : pattern::place_fan(layout, fan, polygon)) {
        frame.nodes.emplace_back(point.x, point.y, 0.0);
    }
    for (const auto& [first, second] : fan.edges) {
        frame.beams.push_back(
            {.nodes = {mechanics::NodeIndex(first.value), mechanics::NodeIndex(second.value)},
             .section = bars.section,
             .material = bars.material});
    }
    return frame;
}

mechanics::Frame fan_frame(const pattern::NodeLayout& layout, const pattern::Fan& fan,
                           const geometry::Polygon& polygon, const Setting& setting) {
    mechanics::Frame frame = fan_frame(layout, fan, polygon, {setting.section, setting.material});
    if (setting.joints == Joints::Centreline) return frame;
    const auto places = pattern::place_fan(layout, fan, polygon);
    const std::vector<double> reaches = joint_reaches(fan, places);
    for (std::size_t i = 0; i < frame.beams.size(); ++i) {
        const auto [first, second] = frame.beams[i].nodes;
        const double length = (frame.nodes[second] - frame.nodes[first]).norm();
        const TileMaterial bar = bar_of(setting, {.length = length, .joint_reach = reaches[i]});
        frame.beams[i].section = bar.section;
        frame.beams[i].material = bar.material;
    }
    return frame;
}

mechanics::Frame pattern_frame(const pattern::NodeLayout& layout, const pattern::Pattern& pattern,
                               const geometry::Polygon& polygon, const TileMaterial& bars) {
    return fan_frame(layout, pattern::make_fan(layout, pattern, static_cast<int>(polygon.size())), polygon,
                     bars);
}

mechanics::Frame pattern_frame(const pattern::NodeLayout& layout, const pattern::Pattern& pattern,
                               const Setting& setting) {
    return fan_frame(layout, pattern::make_fan(layout, pattern, setting.sides),
                     geometry::regular_polygon(setting.sides, setting.tile_side), setting);
}

mechanics::Frame scenario_frame(mechanics::Frame tile, const Scenario& scenario) {
    const auto supports = detail::supports_of(scenario);
    const auto loads = detail::loads_of(scenario, scenario.max_magnitude);
    tile.supports.insert(tile.supports.end(), supports.begin(), supports.end());
    tile.loads.insert(tile.loads.end(), loads.begin(), loads.end());
    return tile;
}

void apply_scenario(const Scenario& scenario, mechanics::Assembly& tile) {
    const auto supports = detail::supports_of(scenario);
    tile.supports.insert(tile.supports.end(), supports.begin(), supports.end());
    for (const mechanics::NodalLoad& load : detail::loads_of(scenario, scenario.max_magnitude)) {
        tile.loads.row(load.node).head<3>() += load.force;
        tile.loads.row(load.node).tail<3>() += load.moment;
        tile.has_moments = tile.has_moments || !load.moment.isZero(0.0);
    }
}

Response follow_scenario(const LoadedTile& tile, const Scenario& scenario, const Setting& setting,
                         const base::Control& control) {
    const auto solutions = mechanics::follow_load_path(
        tile.structure, mechanics::even_load_factors(setting.magnitudes), {.control = control});
    return to_response(solutions, scenario, tile.interface_nodes);
}

std::vector<Response> compute_responses(const pattern::NodeLayout& layout, const pattern::Pattern& pattern,
                                        const Setting& setting, const ResponseOptions& options) {
    setting.validate();
    const auto nodes_a_side = static_cast<int>(layout.interface_nodes().size());
    const FreeTile tile{mechanics::refined(pattern_frame(layout, pattern, setting), setting.divisions),
                        setting.sides * nodes_a_side, setting.magnitudes};
    mechanics::validate(
        scenario_frame(tile.frame, spread_over_sides(setting.scenarios.front(), nodes_a_side)));
    const base::Task task(options.control, "responses", setting.scenarios.size());
    std::vector<Response> responses;
    for (const Scenario& scenario : setting.scenarios) {
        responses.push_back(respond(tile, spread_over_sides(scenario, nodes_a_side), options));
        task.update(responses.size());
    }
    return responses;
}

}  // namespace fretwork::reduction
