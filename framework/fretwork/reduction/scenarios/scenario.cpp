// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/files/file.hpp>
#include <fretwork/mechanics/internal/node_json.hpp>
#include <fretwork/reduction/detail/embedded_scenarios.hpp>
#include <fretwork/reduction/detail/scenario_json.hpp>
#include <fretwork/reduction/scenarios/scenario.hpp>

#include <utility>

namespace fretwork::reduction {
namespace {

using base::Json;
using base::JsonReader;

int read_interface_node(const JsonReader& json) {
    return static_cast<int>(json.at("interface_node").integer(0, kLargestInterfaceNode));
}

mechanics::DofSet read_fixed(const JsonReader& json) {
    mechanics::DofSet dofs;
    for (const JsonReader& element : json.elements()) {
        bool& contained = dofs[mechanics::read_dof(element)];
        if (std::exchange(contained, true)) element.fail("this component is listed twice");
    }
    return dofs;
}

std::array<double, 3> read_vector(const std::optional<JsonReader>& json) {
    if (!json) return {};
    const std::vector<double> values = json->numbers(3);
    return {values[0], values[1], values[2]};
}

Scenario::Support read_support(const JsonReader& json) {
    json.allow_only({"interface_node", "fixed"});
    return {read_interface_node(json), read_fixed(json.at("fixed"))};
}

Scenario::Load read_load(const JsonReader& json) {
    json.allow_only({"interface_node", "force", "moment"});
    if (!json.find("force") && !json.find("moment")) json.fail("a load needs a force or a moment");
    return {read_interface_node(json), read_vector(json.find("force")), read_vector(json.find("moment"))};
}

/// Check that the sketch and the reason of the magnitude are texts. Both are documentation, and are otherwise
/// ignored.
void check_remarks(const JsonReader& json) {
    if (const auto sketch = json.find("sketch")) {
        for (const JsonReader& line : sketch->elements()) (void)line.string();
    }
    if (const auto reason = json.find("max_magnitude_reason")) (void)reason->string();
}

Json support_json(const Scenario::Support& support) {
    return {{"interface_node", support.interface_node}, {"fixed", mechanics::dofs_json(support.fixed)}};
}

Json load_json(const Scenario::Load& load) {
    return {{"interface_node", load.interface_node}, {"force", load.force}, {"moment", load.moment}};
}

/// Append a copy of `part` for each node of its side.
template <class Part>
void add_for_side(std::vector<Part>& parts, const Part& part, int nodes_a_side) {
    if (part.interface_node < 0 || part.interface_node > kLargestInterfaceNode)
        throw base::InputError("there is no interface node " + std::to_string(part.interface_node) +
                               " in a scenario; they run from 0 to " + std::to_string(kLargestInterfaceNode));
    for (int node = 0; node < nodes_a_side; ++node) {
        parts.push_back(part);
        parts.back().interface_node = part.interface_node * nodes_a_side + node;
    }
}

Scenario::Load share_of(const Scenario::Load& load, int nodes_a_side) {
    Scenario::Load share = load;
    for (double& component : share.force) component /= nodes_a_side;
    for (double& component : share.moment) component /= nodes_a_side;
    return share;
}

}  // namespace

namespace detail {

Scenario read_scenario(const JsonReader& json) {
    if (json.find("format") || json.pointer().empty()) json.expect_format("scenario");
    json.allow_only({"format", "name", "description", "sketch", "weight", "max_magnitude",
                     "max_magnitude_reason", "held", "loads"});
    check_remarks(json);
    Scenario scenario;
    scenario.name = json.at("name").string();
    if (scenario.name.empty()) json.at("name").fail("a scenario needs a name");
    if (const auto description = json.find("description")) scenario.description = description->string();
    scenario.weight = json.at("weight").positive_number();
    scenario.max_magnitude = json.at("max_magnitude").positive_number();
    for (const JsonReader& support : json.at("held").elements())
        scenario.supports.push_back(read_support(support));
    for (const JsonReader& load : json.at("loads").elements()) scenario.loads.push_back(read_load(load));
    if (scenario.loads.empty()) json.at("loads").fail("a scenario needs a load");
    return scenario;
}

Json scenario_json(const Scenario& scenario) {
    Json json = {{"name", scenario.name},     {"description", scenario.description},
                 {"weight", scenario.weight}, {"max_magnitude", scenario.max_magnitude},
                 {"held", Json::array()},     {"loads", Json::array()}};
    for (const auto& support : scenario.supports) json["held"].push_back(support_json(support));
    for (const auto& load : scenario.loads) json["loads"].push_back(load_json(load));
    return json;
}

}  // namespace detail

const std::vector<Scenario>& paper_scenarios() {
    static const std::vector<Scenario> scenarios = [] {
        std::vector<Scenario> result;
        for (const auto& [name, text] : embedded_scenarios) {
            result.push_back(parse_scenario(text, "scenario " + std::string(name)));
        }
        return result;
    }();
    return scenarios;
}

Scenario spread_over_sides(const Scenario& scenario, int nodes_a_side) {
    if (nodes_a_side < 1 || nodes_a_side > kMostNodesASide)
        throw base::InputError("the number of interface nodes on each side is " +
                               std::to_string(nodes_a_side) + ", where 1 to " +
                               std::to_string(kMostNodesASide) + " are possible");
    Scenario spread = scenario;
    spread.supports.clear();
    spread.loads.clear();
    for (const auto& support : scenario.supports) add_for_side(spread.supports, support, nodes_a_side);
    for (const auto& load : scenario.loads)
        add_for_side(spread.loads, share_of(load, nodes_a_side), nodes_a_side);
    return spread;
}

Scenario parse_scenario(std::string_view text, std::string source) {
    return detail::read_scenario(JsonReader::from_text(text, std::move(source)));
}

std::string scenario_text(const Scenario& scenario) {
    Json json = detail::scenario_json(scenario);
    json["format"] = "fretwork/scenario/1";
    return base::json_text(json);
}

Scenario read_scenario(const std::filesystem::path& path) {
    return detail::read_scenario(JsonReader::from_file(path));
}

void write_scenario(const Scenario& scenario, const std::filesystem::path& path) {
    base::write_file_atomically(path, scenario_text(scenario));
}

}  // namespace fretwork::reduction
