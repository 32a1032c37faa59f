// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/file.hpp>
#include <fretwork/base/internal/json_text.hpp>
#include <fretwork/base/json_reader.hpp>
#include <fretwork/base/provenance.hpp>
#include <fretwork/mechanics/result_file.hpp>

#include <limits>

namespace fretwork::mechanics {
namespace {

using base::Json;
using base::JsonReader;

constexpr Termination kTerminations[] = {Termination::Converged, Termination::LimitLoad,
                                         Termination::Diverged, Termination::IterationsSpent};
constexpr StabilityTest kStabilityTests[] = {StabilityTest::None, StabilityTest::Tangent,
                                             StabilityTest::SymmetricPart};

Json rows_json(const NodeValues& values) {
    Json rows = Json::array();
    for (Eigen::Index i = 0; i < values.rows(); ++i) {
        Json row = Json::array();
        for (int d = 0; d < kDofsPerNode; ++d) row.push_back(values(i, d));
        rows.push_back(std::move(row));
    }
    return rows;
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
                                            {"node", nodes[static_cast<std::size_t>(loss.node.value)].id},
                                            {"component", kDofNames[static_cast<std::size_t>(loss.dof)]},
                                            {"pushed", loss.pushed}});
    json["displacements"] = rows_json(solution.displacements);
    json["reactions"] = rows_json(solution.reactions);
}

NodeValues read_rows(const JsonReader& reader, std::size_t count) {
    NodeValues values(static_cast<Eigen::Index>(count), kDofsPerNode);
    Eigen::Index i = 0;
    for (const JsonReader& row : reader.elements(count)) {
        const std::vector<double> numbers = row.numbers(kDofsPerNode);
        for (int d = 0; d < kDofsPerNode; ++d) values(i, d) = numbers[static_cast<std::size_t>(d)];
        ++i;
    }
    return values;
}

Termination read_termination(const JsonReader& reader) {
    const std::string name = reader.choice({"converged", "limit-load", "diverged", "iterations-spent"});
    for (const Termination termination : kTerminations) {
        if (termination_name(termination) == name) return termination;
    }
    reader.fail("is " + reader.text() + ", which is no way to end");
}

StabilityTest read_stability(const JsonReader& reader) {
    const std::string name = reader.choice({"none", "tangent", "symmetric-part"});
    for (const StabilityTest test : kStabilityTests) {
        if (stability_test_name(test) == name) return test;
    }
    reader.fail("is " + reader.text() + ", which is no test of stability");
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
    const std::string name = reader.at("component").choice({"ux", "uy", "uz", "rx", "ry", "rz"});
    for (int d = 0; d < kDofsPerNode; ++d) {
        if (kDofNames[static_cast<std::size_t>(d)] == name) loss.dof = static_cast<Dof>(d);
    }
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
    solution.residual = reader.at("residual").number();
    solution.iterations =
        static_cast<int>(reader.at("iterations").integer(0, std::numeric_limits<int>::max()));
    if (const auto losses = reader.find("stability_losses")) {
        for (const JsonReader& loss : losses->elements())
            solution.stability_losses.push_back(read_loss(loss, nodes));
    }
    solution.displacements = read_rows(reader.at("displacements"), nodes.size());
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
    return {reader.at("displacement").number(), reader.at("rotation").number(), reader.at("share").number(),
            reader.at("known").boolean()};
}

Json subject_json(const ResultSubject& subject) {
    return {{"model", subject.model},
            {"is_reference", subject.is_reference},
            {"load_case", Json::parse(subject.load_case_text)},
            {"tessellation", subject.tessellation_hash},
            {"painting", subject.painting_hash},
            {"setting", subject.setting_hash}};
}

ResultSubject read_subject(const JsonReader& reader) {
    reader.allow_only({"model", "is_reference", "load_case", "tessellation", "painting", "setting"});
    return {.model = reader.at("model").string(),
            .is_reference = reader.at("is_reference").boolean(),
            .load_case = reader.at("load_case").at("name").string(),
            .load_case_text = reader.at("load_case").text(),
            .tessellation_hash = reader.at("tessellation").string(),
            .painting_hash = reader.at("painting").string(),
            .setting_hash = reader.at("setting").string()};
}

Result::Node read_node(const JsonReader& reader) {
    reader.allow_only({"id", "rest_position", "interface"});
    const std::vector<double> position = reader.at("rest_position").numbers(3);
    return {static_cast<int>(reader.at("id").integer(0, std::numeric_limits<int>::max())),
            {position[0], position[1], position[2]},
            reader.at("interface").boolean()};
}

}  // namespace

std::string result_text(const Result& result) {
    Json json = {{"format", "fretwork/result/2"}, {"program", base::version()}, {"solver", result.solver}};
    if (result.subject) json["subject"] = subject_json(*result.subject);
    append_solution(json, result.solution, result.nodes);
    json["seconds"] = result.seconds;
    json["nodes"] = Json::array();
    for (const Result::Node& node : result.nodes) {
        const Eigen::Vector3d& p = node.rest_position;
        json["nodes"].push_back(
            {{"id", node.id}, {"rest_position", {p.x(), p.y(), p.z()}}, {"interface", node.is_interface}});
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
    document.expect_format("result", 2);
    document.allow_only({"format",          "program",        "subject",
                         "solver",          "load_factor",    "converged",
                         "stable",          "stability",      "termination",
                         "energy",          "residual",       "iterations",
                         "displacements",   "reactions",      "seconds",
                         "nodes",           "load_steps",     "stability_losses",
                         "vibration_modes", "buckling_modes", "discretization_error"});
    Result result;
    result.solver = document.at("solver").string();
    if (const auto program = document.find("program")) result.program = program->string();
    if (const auto subject = document.find("subject")) result.subject = read_subject(*subject);
    for (const JsonReader& node : document.at("nodes").elements()) result.nodes.push_back(read_node(node));
    result.solution = read_solution(document, result.nodes);
    result.seconds = document.at("seconds").number();
    if (const auto steps = document.find("load_steps")) {
        for (const JsonReader& step : steps->elements()) {
            step.allow_only({"load_factor", "converged", "stable", "stability", "termination", "energy",
                             "residual", "iterations", "displacements", "reactions", "stability_losses"});
            result.load_steps.push_back(read_solution(step, result.nodes));
        }
    }
    if (const auto error = document.find("discretization_error"))
        result.discretization_error = read_error(*error);
    if (const auto modes = document.find("vibration_modes"))
        result.vibration_modes = read_modes(*modes, "frequency", result.nodes.size());
    if (const auto modes = document.find("buckling_modes"))
        result.buckling_modes = read_modes(*modes, "load_factor", result.nodes.size());
    return result;
}

}  // namespace fretwork::mechanics
