// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/files/file.hpp>
#include <fretwork/base/files/provenance.hpp>
#include <fretwork/base/internal/json_text.hpp>
#include <fretwork/base/json_reader.hpp>
#include <fretwork/base/limits.hpp>
#include <fretwork/base/named.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/mechanics/internal/node_json.hpp>
#include <fretwork/mechanics/internal/result_json.hpp>
#include <fretwork/mechanics/results/result_file.hpp>
#include <fretwork/mechanics/solve.hpp>

#include <algorithm>
#include <limits>
#include <unordered_set>

namespace fretwork::mechanics {
namespace {

using base::Json;
using base::JsonReader;

/// The newest format that is read. Formats before 4 were written by unreleased versions only.
constexpr int kNewestVersion = 5;
constexpr int kOldestVersion = 4;
constexpr std::string_view kResultKeys[] = {
    "format",     "program",          "solver",          "load_factor",    "converged",
    "stable",     "stability",        "termination",     "energy",         "residual",
    "iterations", "displacements",    "reactions",       "seconds",        "nodes",
    "load_steps", "stability_losses", "vibration_modes", "buckling_modes", "discretization_error"};

constexpr Termination kTerminations[] = {Termination::Converged, Termination::LimitLoad,
                                         Termination::Diverged, Termination::IterationsSpent};
constexpr StabilityTest kStabilityTests[] = {StabilityTest::None, StabilityTest::Tangent,
                                             StabilityTest::SymmetricPart};

Json rows_json(const NodeValues& values) {
    return base::number_rows({values.data(), static_cast<std::size_t>(values.size())}, kDofsPerNode);
}

void append_solution(Json& json, const Solution& solution, const std::vector<Result::Node>& nodes) {
    json["load_factor"] = solution.load_factor;
    json["converged"] = solution.converged();
    json["stable"] = solution.stable;
    json["stability"] = stability_test_name(solution.stability);
    json["termination"] = termination_name(solution.termination);
    json["energy"] = solution.energy;
    json["residual"] = solution.residual;
    json["iterations"] = solution.iterations;
    for (const StabilityLoss& loss : solution.stability_losses)
        json["stability_losses"].push_back({{"load_factor", loss.load_factor},
                                            {"node", nodes[loss.node].id},
                                            {"component", dof_name(loss.dof)},
                                            {"pushed", loss.pushed}});
    json["displacements"] = rows_json(solution.displacements);
    json["reactions"] = rows_json(solution.reactions);
}

/// Read numbers that are finite, and have no other limits: shapes of modes have no unit, and the reactions of
/// a valid frame may be far larger than its loads may be.
NodeValues read_rows(const JsonReader& reader, std::size_t count) {
    NodeValues values(static_cast<Eigen::Index>(count), kDofsPerNode);
    Eigen::Index i = 0;
    for (const JsonReader& row : reader.elements(count)) {
        const std::vector<double> numbers = row.numbers(kDofsPerNode);
        for (int d = 0; d < kDofsPerNode; ++d) values(i, d) = numbers[d];
        ++i;
    }
    return values;
}

NodeValues read_motions(const JsonReader& reader, std::size_t count) {
    NodeValues motions = read_rows(reader, count);
    for (Eigen::Index i = 0; i < motions.rows(); ++i) {
        for (int d = 0; d < kDofsPerNode; ++d) {
            const base::Limits& allowed = motion_limits(static_cast<Dof>(d));
            if (!base::is_within(motions(i, d), allowed))
                reader.elements()[static_cast<std::size_t>(i)].fail(
                    "has " + base::format_number(motions(i, d)) + ", where " + base::range_text(allowed) +
                    " is needed");
        }
    }
    return motions;
}

Termination read_termination(const JsonReader& reader) {
    const std::string name = reader.string();
    return reader.located([&] { return base::find_named(name, kTerminations, termination_name, "choice"); });
}

StabilityTest read_stability(const JsonReader& reader) {
    const std::string name = reader.string();
    return reader.located(
        [&] { return base::find_named(name, kStabilityTests, stability_test_name, "choice"); });
}

StabilityLoss read_loss(const JsonReader& reader, const std::vector<Result::Node>& nodes) {
    reader.allow_only({"load_factor", "node", "component", "pushed"});
    StabilityLoss loss;
    loss.load_factor = reader.at("load_factor").number();
    const auto id = reader.at("node").integer(0, std::numeric_limits<int>::max());
    const auto named = std::ranges::find(nodes, id, &Result::Node::id);
    if (named == nodes.end())
        reader.at("node").fail("is " + std::to_string(id) + ", and no node has that id");
    loss.node = NodeIndex(named - nodes.begin());
    loss.dof = read_dof(reader.at("component"));
    loss.pushed = reader.at("pushed").boolean();
    return loss;
}

std::vector<Mode> read_modes(const JsonReader& reader, std::string_view value, std::size_t nodes) {
    std::vector<Mode> modes;
    for (const JsonReader& mode : reader.elements()) {
        mode.allow_only({value, "shape"});
        modes.push_back({mode.at(value).positive_number(), read_rows(mode.at("shape"), nodes)});
    }
    return modes;
}

Solution read_solution(const JsonReader& reader, const std::vector<Result::Node>& nodes) {
    Solution solution;
    solution.load_factor = reader.at("load_factor").number();
    solution.termination = read_termination(reader.at("termination"));
    if (reader.at("converged").boolean() != solution.converged())
        reader.at("converged").fail("does not agree with the termination");
    solution.stable = reader.at("stable").boolean();
    solution.stability = read_stability(reader.at("stability"));
    solution.energy = reader.at("energy").number();
    solution.residual = read_not_negative(reader.at("residual"));
    solution.iterations =
        static_cast<int>(reader.at("iterations").integer(0, std::numeric_limits<int>::max()));
    if (const auto losses = reader.find("stability_losses")) {
        for (const JsonReader& loss : losses->elements())
            solution.stability_losses.push_back(read_loss(loss, nodes));
    }
    solution.displacements = read_motions(reader.at("displacements"), nodes.size());
    solution.reactions = read_rows(reader.at("reactions"), nodes.size());
    return solution;
}

Json error_json(const DiscretizationError& error) {
    return {{"displacement", error.displacement},
            {"rotation", error.rotation},
            {"share", error.share},
            {"known", error.known}};
}

DiscretizationError read_error(const JsonReader& reader) {
    reader.allow_only({"displacement", "rotation", "share", "known"});
    return {read_not_negative(reader.at("displacement")), read_not_negative(reader.at("rotation")),
            read_not_negative(reader.at("share")), reader.at("known").boolean()};
}

Result::Node read_node(const JsonReader& reader) {
    reader.allow_only({"id", "rest_position", "interface"});
    const std::vector<double> position = reader.at("rest_position").numbers(3);
    return {static_cast<int>(reader.at("id").integer(0, std::numeric_limits<int>::max())),
            {position[0], position[1], position[2]},
            reader.at("interface").boolean()};
}

std::string read_solver(const JsonReader& reader) {
    std::string name = reader.string();
    reader.located([&] { (void)find_solver(name); });
    return name;
}

std::vector<Result::Node> read_nodes(const JsonReader& reader) {
    std::vector<Result::Node> nodes;
    std::unordered_set<int> ids;
    for (const JsonReader& node : reader.elements()) {
        nodes.push_back(read_node(node));
        if (!ids.insert(nodes.back().id).second)
            node.at("id").fail("is " + std::to_string(nodes.back().id) + ", the id of a node before it");
    }
    return nodes;
}

/// Check that the result equals the last of its load steps.
void check_end(const JsonReader& document, const Result& result) {
    if (result.load_steps.empty()) return;
    const Solution& last = result.load_steps.back();
    const Solution& end = result.solution;
    const auto require = [&](const char* key, bool agrees) {
        if (!agrees) document.at(key).fail("differs from that of the last of the load_steps");
    };
    require("load_factor", end.load_factor == last.load_factor);
    require("termination", end.termination == last.termination);
    require("displacements", end.displacements == last.displacements);
    require("reactions", end.reactions == last.reactions);
}

std::vector<Solution> read_steps(const JsonReader& reader, const std::vector<Result::Node>& nodes) {
    std::vector<Solution> steps;
    for (const JsonReader& step : reader.elements()) {
        step.allow_only({"load_factor", "converged", "stable", "stability", "termination", "energy",
                         "residual", "iterations", "displacements", "reactions", "stability_losses"});
        steps.push_back(read_solution(step, nodes));
    }
    return steps;
}

}  // namespace

void append_result(const Result& result, Json& json) {
    json["solver"] = result.solver;
    append_solution(json, result.solution, result.nodes);
    json["seconds"] = result.seconds;
    json["nodes"] = Json::array();
    for (const Result::Node& node : result.nodes) {
        json["nodes"].push_back({{"id", node.id},
                                 {"rest_position", vector_json(node.rest_position)},
                                 {"interface", node.is_interface}});
    }
    for (const Solution& step : result.load_steps) {
        Json step_json = Json::object();
        append_solution(step_json, step, result.nodes);
        json["load_steps"].push_back(std::move(step_json));
    }
    for (const Mode& mode : result.vibration_modes)
        json["vibration_modes"].push_back({{"frequency", mode.value}, {"shape", rows_json(mode.shape)}});
    if (result.discretization_error) json["discretization_error"] = error_json(*result.discretization_error);
    for (const Mode& mode : result.buckling_modes)
        json["buckling_modes"].push_back({{"load_factor", mode.value}, {"shape", rows_json(mode.shape)}});
}

void check_result_format(const JsonReader& document, std::span<const std::string_view> more_keys) {
    document.expect_format("result", kNewestVersion, kOldestVersion);
    std::vector<std::string_view> keys(std::begin(kResultKeys), std::end(kResultKeys));
    keys.insert(keys.end(), more_keys.begin(), more_keys.end());
    document.allow_only(keys);
}

double read_not_negative(const JsonReader& reader) {
    const double value = reader.number();
    if (value < 0) reader.fail("is " + reader.text() + ", where a number not below zero is needed");
    return value;
}

Result read_result(const JsonReader& document) {
    Result result;
    result.solver = read_solver(document.at("solver"));
    result.program = document.at("program").string();
    result.nodes = read_nodes(document.at("nodes"));
    result.solution = read_solution(document, result.nodes);
    result.seconds = read_not_negative(document.at("seconds"));
    if (const auto steps = document.find("load_steps")) result.load_steps = read_steps(*steps, result.nodes);
    check_end(document, result);
    if (const auto error = document.find("discretization_error"))
        result.discretization_error = read_error(*error);
    if (const auto modes = document.find("vibration_modes"))
        result.vibration_modes = read_modes(*modes, "frequency", result.nodes.size());
    if (const auto modes = document.find("buckling_modes"))
        result.buckling_modes = read_modes(*modes, "load_factor", result.nodes.size());
    return result;
}

std::string result_text(const Result& result) {
    Json json = {{"format", kResultFormat}, {"program", base::version()}};
    append_result(result, json);
    return base::json_text(json);
}

void write_result(const Result& result, const std::filesystem::path& path) {
    base::write_file_atomically(path, result_text(result));
}

Result read_result(const std::filesystem::path& path) {
    return parse_result(base::read_text_file(path), path.string());
}

Result parse_result(std::string_view text, const std::string& source) {
    const JsonReader document = JsonReader::from_text(text, source);
    check_result_format(document);
    return read_result(document);
}

}  // namespace fretwork::mechanics
