// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/files/file.hpp>
#include <fretwork/base/internal/json_text.hpp>
#include <fretwork/base/json_reader.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/design/target/target_file.hpp>
#include <fretwork/outlines/flat_mesh.hpp>
#include <fretwork/simulation/internal/load_case_json.hpp>
#include <fretwork/tiling/painting/field.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fretwork::design {
namespace {

using base::Json;
using base::JsonReader;

constexpr double kFarthest = 1e4;  // m

double read_bounded(const JsonReader& json) {
    const double value = json.number();
    if (!(std::abs(value) <= kFarthest))
        json.fail("is " + json.text() + ", where a number from -10000 to 10000, or null, is needed");
    return value;
}

std::optional<double> read_component(const JsonReader& json) {
    if (json.is_null()) return std::nullopt;
    return read_bounded(json);
}

FreeVector read_free_vector(const JsonReader& json) {
    const auto components = json.elements(3);
    FreeVector vector;
    for (std::size_t i = 0; i < 3; ++i) vector[i] = read_component(components[i]);
    if (!vector[0] && !vector[1] && !vector[2])
        json.fail("leaves all three components free: it asks for nothing");
    return vector;
}

NodesGoal read_nodes_goal(const JsonReader& json) {
    NodesGoal goal;
    for (const JsonReader& node : json.at("nodes").elements())
        goal.nodes.push_back(static_cast<int>(node.integer(0, 1'000'000'000)));
    if (goal.nodes.empty()) json.at("nodes").fail("is empty, where at least one interface node is needed");
    const auto displacements = json.find("displacements");
    const auto positions = json.find("positions");
    if (displacements.has_value() == positions.has_value())
        json.fail("must give its nodes either displacements or positions");
    goal.quantity = positions ? NodesGoal::Quantity::Positions : NodesGoal::Quantity::Displacements;
    const JsonReader& values = positions ? *positions : *displacements;
    for (const JsonReader& value : values.elements(goal.nodes.size()))
        goal.values.push_back(read_free_vector(value));
    return goal;
}

std::optional<std::string> read_expression(const JsonReader& json) {
    if (json.is_null()) return std::nullopt;
    if (json.is_number()) {
        (void)read_bounded(json);
        return json.text();
    }
    if (!json.is_string())
        json.fail("is " + json.text() + ", where a number, an expression of x and y, or null is needed");
    std::string expression = json.string();
    json.located([&] { (void)tiling::expression_values(expression, {}, {}); });
    return expression;
}

FormulaGoal read_formula_goal(const simulation::Selection& where, const JsonReader& json) {
    FormulaGoal goal{where, {}};
    const auto components = json.elements(3);
    for (std::size_t i = 0; i < 3; ++i) goal.displacement[i] = read_expression(components[i]);
    if (!goal.displacement[0] && !goal.displacement[1] && !goal.displacement[2])
        json.fail("leaves all three components free: it asks for nothing");
    return goal;
}

void read_selected_goal(const JsonReader& json, Goal& goal) {
    const JsonReader select = json.at("select");
    select.allow_only(simulation::kSelectionKeys);
    const simulation::Selection where = simulation::read_selection(select);
    const auto displacement = json.find("displacement");
    const auto surface = json.find("surface");
    const auto rotation = json.find("rotation");
    if (displacement.has_value() + surface.has_value() + rotation.has_value() != 1)
        json.fail("must ask of the selected nodes exactly one of displacement, surface, rotation");
    if (displacement) goal.what = read_formula_goal(where, *displacement);
    if (surface) {
        const std::filesystem::path mesh = surface->string();
        surface->located([&] { outlines::check_mesh_ending(mesh); });
        goal.what = MeshGoal{where, mesh};
    }
    if (rotation) goal.what = RotationGoal{where, read_free_vector(*rotation)};
}

Goal read_goal(const JsonReader& json) {
    Goal goal;
    if (json.find("select")) {
        json.allow_only({"select", "displacement", "surface", "rotation", "weight", "case"});
        read_selected_goal(json, goal);
    } else if (json.find("nodes")) {
        json.allow_only({"nodes", "displacements", "positions", "weight", "case"});
        goal.what = read_nodes_goal(json);
    } else {
        json.fail("names no nodes: it needs nodes or select");
    }
    if (const auto weight = json.find("weight")) goal.weight = weight->number();
    if (const auto load_case = json.find("case")) goal.load_case = load_case->string();
    json.located([&] { goal.validate(); });
    return goal;
}

/// True if a goal selects nodes by a circle, which the first format does not have.
bool has_circle(const Target& target) {
    const auto is_on_circle = [](const auto& what) {
        if constexpr (requires { what.where; })
            return simulation::is_circle(what.where);
        else
            return false;
    };
    return std::ranges::any_of(target.goals,
                               [&](const Goal& goal) { return std::visit(is_on_circle, goal.what); });
}

Target read_target_json(const JsonReader& json) {
    json.expect_format("target", 2);
    json.allow_only({"format", "name", "description", "goals"});
    Target target;
    if (const auto name = json.find("name")) target.name = name->string();
    if (const auto description = json.find("description")) target.description = description->string();
    for (const JsonReader& goal : json.at("goals").elements()) target.goals.push_back(read_goal(goal));
    if (target.goals.empty()) json.at("goals").fail("is empty, where at least one goal is needed");
    if (has_circle(target)) json.require_format(kTargetFormat, "circle");
    return target;
}

/// Checks that a goal has one value for each node, and only finite ones.
void require_values(const NodesGoal& goal) {
    const char* const place =
        goal.quantity == NodesGoal::Quantity::Positions ? "/positions" : "/displacements";
    if (goal.values.size() != goal.nodes.size())
        throw base::InputError("", place,
                               "has " + base::counted(goal.values.size(), "value") + " for " +
                                   base::counted(goal.nodes.size(), "node") +
                                   ", where one for each node is needed");
    const auto is_finite = [](const std::optional<double>& own) { return !own || std::isfinite(*own); };
    for (std::size_t i = 0; i < goal.nodes.size(); ++i) {
        if (std::ranges::all_of(goal.values[i], is_finite)) continue;
        throw base::InputError("", place,
                               "has a number for node " + std::to_string(goal.nodes[i]) +
                                   " that is not finite, where metres, or none (free), are needed");
    }
}

Json free_vector_json(const FreeVector& vector) {
    Json json = Json::array();
    for (const auto& component : vector) json.push_back(base::or_null(component));
    return json;
}

Json selection_json(const simulation::Selection& where) {
    Json json = Json::object();
    simulation::write_selection(where, json);
    return json;
}

Json content_json(const NodesGoal& goal) {
    Json values = Json::array();
    for (const FreeVector& value : goal.values) values.push_back(free_vector_json(value));
    const char* key = goal.quantity == NodesGoal::Quantity::Positions ? "positions" : "displacements";
    return {{"nodes", goal.nodes}, {key, values}};
}

Json content_json(const FormulaGoal& goal) {
    Json components = Json::array();
    for (const auto& component : goal.displacement) components.push_back(base::or_null(component));
    return {{"select", selection_json(goal.where)}, {"displacement", components}};
}

Json content_json(const MeshGoal& goal) {
    return {{"select", selection_json(goal.where)}, {"surface", goal.mesh.string()}};
}

Json content_json(const RotationGoal& goal) {
    return {{"select", selection_json(goal.where)}, {"rotation", free_vector_json(goal.rotation)}};
}

Json goal_json(const Goal& goal) {
    Json json = std::visit([](const auto& what) { return content_json(what); }, goal.what);
    if (goal.weight != 1.0) json["weight"] = goal.weight;
    if (!goal.load_case.empty()) json["case"] = goal.load_case;
    return json;
}

}  // namespace

void Goal::validate() const {
    if (!(weight >= kLeastWeight && weight <= kMostWeight))
        throw base::InputError(
            "", "/weight",
            "is " + base::format_number(weight) + ", where a number from 1e-6 to 1e6 is needed");
    if (const auto* own = std::get_if<NodesGoal>(&what)) require_values(*own);
    const auto* turn = std::get_if<RotationGoal>(&what);
    if (turn == nullptr) return;
    double square = 0.0;
    for (const auto& component : turn->rotation) square += component.value_or(0.0) * component.value_or(0.0);
    if (!(std::sqrt(square) <= std::numbers::pi))
        throw base::InputError("", "/rotation",
                               "is a rotation vector of " + base::format_number(std::sqrt(square), 4) +
                                   " rad, where at most pi (half a turn) is possible");
}

Target parse_target(std::string_view text, const std::string& source) {
    return read_target_json(JsonReader::from_text(text, source));
}

std::string target_text(const Target& target) {
    Json goals = Json::array();
    for (const Goal& goal : target.goals) goals.push_back(goal_json(goal));
    // Older programs read all targets without circles.
    return base::json_text({{"format", has_circle(target) ? kTargetFormat : "fretwork/target/1"},
                            {"name", target.name},
                            {"description", target.description},
                            {"goals", goals}});
}

Target read_target(const std::filesystem::path& path) {
    Target target = read_target_json(JsonReader::from_file(path));
    for (Goal& goal : target.goals) {
        auto* mesh = std::get_if<MeshGoal>(&goal.what);
        if (mesh != nullptr && mesh->mesh.is_relative()) mesh->mesh = path.parent_path() / mesh->mesh;
    }
    return target;
}

void write_target(const Target& target, const std::filesystem::path& path) {
    base::write_file_atomically(path, target_text(target));
}

}  // namespace fretwork::design
