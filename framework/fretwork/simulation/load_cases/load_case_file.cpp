// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/files/file.hpp>
#include <fretwork/base/limits.hpp>
#include <fretwork/mechanics/internal/node_json.hpp>
#include <fretwork/simulation/internal/load_case_json.hpp>
#include <fretwork/simulation/load_cases/load_case_file.hpp>

#include <algorithm>

namespace fretwork::simulation {
namespace {

using base::Json;
using base::JsonReader;
using mechanics::Dof;
using mechanics::kDofNames;
using mechanics::vector_json;

constexpr base::Limits kPerLengthLimits{1e-21, 1e15, "N/m"};
constexpr base::Limits kPerAreaLimits{1e-24, 1e18, "N/m2"};

double read_number(const JsonReader& json, const base::Limits& limits) {
    const double value = json.number();
    if (!base::is_within(value, limits))
        json.fail("is " + json.text() + ", where " + base::range_text(limits) + " is needed");
    return value;
}

Eigen::Vector3d read_vector(const std::optional<JsonReader>& json, const base::Limits& limits) {
    if (!json) return Eigen::Vector3d::Zero();
    const auto numbers = json->elements(3);
    return {read_number(numbers[0], limits), read_number(numbers[1], limits),
            read_number(numbers[2], limits)};
}

NodesById read_ids(const JsonReader& json) {
    NodesById selection;
    for (const JsonReader& id : json.elements())
        selection.ids.push_back(static_cast<int>(id.integer(0, 1'000'000'000)));
    if (selection.ids.empty()) json.fail("is empty, where at least one id of an interface node is needed");
    return selection;
}

NodesInBox read_box(const JsonReader& json) {
    const std::vector<double> box = json.numbers(4);
    if (box[0] > box[2] || box[1] > box[3])
        json.fail("is " + json.text() + ", where xmin ymin xmax ymax are needed");
    return {{box[0], box[1], box[2], box[3]}};
}

NodesInCircle read_circle(const JsonReader& json) {
    json.allow_only({"center", "radius"});
    const std::vector<double> center = json.at("center").numbers(2);
    return {{center[0], center[1]}, json.at("radius").positive_number()};
}

NodesNearest read_nearest(const JsonReader& json) {
    NodesNearest selection;
    for (const JsonReader& point : json.elements()) {
        const std::vector<double> place = point.numbers(2);
        selection.points.push_back({place[0], place[1]});
    }
    if (selection.points.empty()) json.fail("is empty, where at least one point is needed");
    return selection;
}

NodesAtSide read_side(const JsonReader& json) {
    const std::string name = json.choice({kSideNames[0], kSideNames[1], kSideNames[2], kSideNames[3]});
    const auto place = std::find(kSideNames.begin(), kSideNames.end(), name);
    return {static_cast<Side>(place - kSideNames.begin())};
}

}  // namespace

Selection read_selection(const JsonReader& json) {
    const auto nodes = json.find("nodes");
    const auto box = json.find("box");
    const auto circle = json.find("circle");
    const auto nearest = json.find("nearest");
    const auto side = json.find("side");
    const auto has_key = [&](std::string_view key) { return json.find(key).has_value(); };
    if (std::ranges::count_if(kSelectionKeys, has_key) != 1)
        json.fail("must pick its nodes by exactly one of nodes, box, circle, nearest, side");
    if (nodes) return read_ids(*nodes);
    if (box) return read_box(*box);
    if (circle) return read_circle(*circle);
    if (nearest) return read_nearest(*nearest);
    return read_side(*side);
}

void write_selection(const Selection& selection, Json& json) {
    if (const auto* ids = std::get_if<NodesById>(&selection)) json["nodes"] = ids->ids;
    if (const auto* box = std::get_if<NodesInBox>(&selection)) json["box"] = box->box;
    if (const auto* circle = std::get_if<NodesInCircle>(&selection))
        json["circle"] = {{"center", {circle->center.x, circle->center.y}}, {"radius", circle->radius}};
    if (const auto* side = std::get_if<NodesAtSide>(&selection)) json["side"] = side_name(side->side);
    if (const auto* nearest = std::get_if<NodesNearest>(&selection)) {
        for (const geometry::Point2& point : nearest->points) json["nearest"].push_back({point.x, point.y});
    }
}

namespace {

std::optional<Dof> dof_of(const std::string& name) {
    const auto place = std::find(kDofNames.begin(), kDofNames.end(), name);
    if (place == kDofNames.end()) return std::nullopt;
    return static_cast<Dof>(place - kDofNames.begin());
}

/// Refuse the keys of an entry that are neither those of a selection nor in `own`. Targets put a selection's
/// keys into "select".
void allow_beside_selection(const JsonReader& json, std::initializer_list<std::string_view> own) {
    if (json.find("select"))
        json.fail(
            "has \"select\", which goals of targets have: an entry of a load case has nodes, box, circle, "
            "nearest or side itself");
    std::vector<std::string_view> keys(kSelectionKeys.begin(), kSelectionKeys.end());
    keys.insert(keys.end(), own);
    json.allow_only(keys);
}

LoadCase::Support read_support(const JsonReader& json) {
    allow_beside_selection(json, {"fixed"});
    return {read_selection(json), mechanics::read_dofs(json.at("fixed"))};
}

Json support_json(const LoadCase::Support& support) {
    Json json;
    write_selection(support.where, json);
    json["fixed"] = mechanics::dofs_json(support.fixed);
    return json;
}

LoadCase::Load read_load(const JsonReader& json) {
    allow_beside_selection(json, {"force", "moment", "amount"});
    if (!json.find("force") && !json.find("moment")) json.fail("has neither a force nor a moment");
    LoadCase::Load load{read_selection(json), read_vector(json.find("force"), base::kForceLimits),
                        read_vector(json.find("moment"), base::kMomentLimits), LoadCase::Amount::Each};
    const auto amount = json.find("amount");
    if (amount && amount->choice({"each", "total"}) == "total") load.amount = LoadCase::Amount::Total;
    return load;
}

LoadCase::Load read_line_load(const JsonReader& json) {
    json.allow_only({"side", "between", "per_length"});
    const auto side = json.find("side");
    const auto between = json.find("between");
    if (side.has_value() == between.has_value())
        json.fail("runs along a side or between two points of the rim: one of side, between is needed");
    LoadCase::Load load{NodesAtSide{}, read_vector(json.at("per_length"), kPerLengthLimits),
                        Eigen::Vector3d::Zero(), LoadCase::Amount::PerLength};
    if (side) {
        load.where = read_side(*side);
    } else {
        (void)between->elements(2);
        load.where = read_nearest(*between);
    }
    return load;
}

Json load_json(const LoadCase::Load& load) {
    Json json;
    if (load.amount == LoadCase::Amount::PerLength) {
        write_selection(load.where, json);
        if (json.contains("nearest")) json["between"] = std::move(json["nearest"]);
        json.erase("nearest");
        json["per_length"] = vector_json(load.force);
        return json;
    }
    write_selection(load.where, json);
    if (!load.force.isZero(0)) json["force"] = vector_json(load.force);
    if (!load.moment.isZero(0)) json["moment"] = vector_json(load.moment);
    if (load.force.isZero(0) && load.moment.isZero(0)) json["force"] = vector_json(load.force);
    if (load.amount == LoadCase::Amount::Total) json["amount"] = "total";
    return json;
}

/// One entry may prescribe several dofs; each becomes one PrescribedDisplacement.
void add_prescribed(const JsonReader& json, const LoadCase::Origin& origin,
                    std::vector<LoadCase::PrescribedDisplacement>& list) {
    allow_beside_selection(json, {"ux", "uy", "uz", "rx", "ry", "rz"});
    const Selection where = read_selection(json);
    const std::size_t before = list.size();
    for (const auto& [key, value] : json.members()) {
        const auto dof = dof_of(key);
        if (!dof) continue;
        const base::Limits& limits = *dof < Dof::rx ? base::kLengthLimits : base::kAngleLimits;
        list.push_back({where, *dof, read_number(value, limits), origin});
    }
    if (list.size() == before) json.fail("prescribes nothing: one of ux, uy, uz, rx, ry, rz is needed");
}

Json displacement_json(const LoadCase::PrescribedDisplacement& prescribed) {
    Json json;
    write_selection(prescribed.where, json);
    json[dof_name(prescribed.dof)] = prescribed.value;
    return json;
}

LoadCase::AreaLoad read_area_load(const JsonReader& json) {
    allow_beside_selection(json, {"tiles", "per_area"});
    const Eigen::Vector3d per_area = read_vector(json.at("per_area"), kPerAreaLimits);
    const auto tiles = json.find("tiles");
    if (!tiles) return {read_selection(json), per_area};
    json.allow_only({"tiles", "per_area"});
    return {LoadCase::AreaLoad::Tiles{read_ids(*tiles).ids}, per_area};
}

Json area_load_json(const LoadCase::AreaLoad& load) {
    Json json;
    if (const auto* where = std::get_if<Selection>(&load.where)) write_selection(*where, json);
    if (const auto* tiles = std::get_if<LoadCase::AreaLoad::Tiles>(&load.where))
        json["tiles"] = tiles->numbers;
    json["per_area"] = vector_json(load.per_area);
    return json;
}

/// The list of loads has loads of all kinds, in any order.
void add_any_load(const JsonReader& json, const LoadCase::Origin& origin, LoadCase& load_case) {
    const bool is_along_line = json.find("per_length").has_value();
    if (!is_along_line && json.find("per_area")) {
        load_case.area_loads.push_back(read_area_load(json));
        load_case.area_loads.back().origin = origin;
        return;
    }
    load_case.loads.push_back(is_along_line ? read_line_load(json) : read_load(json));
    load_case.loads.back().origin = origin;
}

Json share_json(const LoadCase::Share& share) {
    return {{"load_case", share.load_case}, {"factor", share.factor}};
}

template <class Value>
Json list_json(std::span<const Value> values, Json (*to_json)(const Value&)) {
    Json list = Json::array();
    for (const Value& value : values) list.push_back(to_json(value));
    return list;
}

std::vector<JsonReader> elements_of(const JsonReader& json, std::string_view key) {
    const auto list = json.find(key);
    return list ? list->elements() : std::vector<JsonReader>{};
}

bool needs_fourth_format(const LoadCase& load_case) {
    const auto on_circle = [](const auto& entry) { return is_circle(entry.where); };
    const auto area_on_circle = [](const LoadCase::AreaLoad& load) {
        const auto* where = std::get_if<Selection>(&load.where);
        return where != nullptr && is_circle(*where);
    };
    return std::ranges::any_of(load_case.supports, on_circle) ||
           std::ranges::any_of(load_case.loads, on_circle) ||
           std::ranges::any_of(load_case.prescribed, on_circle) ||
           std::ranges::any_of(load_case.area_loads, area_on_circle);
}

bool needs_third_format(const LoadCase& load_case) {
    return std::ranges::any_of(load_case.loads, [](const LoadCase::Load& load) {
        return load.amount == LoadCase::Amount::PerLength;
    });
}

/// A format of load cases, and the key of the load case that the formats before it lack.
struct FormatOfCase {
    std::string_view name;
    std::string_view new_key;
};

FormatOfCase oldest_format(const LoadCase& load_case) {
    if (needs_fourth_format(load_case)) return {"fretwork/load-case/4", "circle"};
    if (needs_third_format(load_case)) return {"fretwork/load-case/3", "per_length"};
    if (!load_case.area_loads.empty()) return {"fretwork/load-case/2", "per_area"};
    if (!load_case.combines.empty()) return {"fretwork/load-case/2", "combines"};
    return {"fretwork/load-case/1", ""};
}

}  // namespace

std::vector<LoadCase::Support> read_supports(const JsonReader& list) {
    std::vector<LoadCase::Support> supports;
    for (const JsonReader& entry : list.elements()) {
        supports.push_back(read_support(entry));
        supports.back().origin.position = supports.size() - 1;
    }
    return supports;
}

std::vector<LoadCase::PrescribedDisplacement> read_prescribed(const JsonReader& list) {
    std::vector<LoadCase::PrescribedDisplacement> prescribed;
    const auto entries = list.elements();
    for (std::size_t i = 0; i < entries.size(); ++i) add_prescribed(entries[i], {i}, prescribed);
    return prescribed;
}

Json supports_json(std::span<const LoadCase::Support> supports) {
    return list_json(supports, support_json);
}

Json prescribed_json(std::span<const LoadCase::PrescribedDisplacement> prescribed) {
    return list_json(prescribed, displacement_json);
}

LoadCase::Share read_share(const JsonReader& json) {
    json.allow_only({"load_case", "factor"});
    constexpr base::Limits kFactorLimits{1e-6, 1e6, "times the load case"};
    return {json.at("load_case").string(), read_number(json.at("factor"), kFactorLimits)};
}

LoadCase read_load_case(const JsonReader& json) {
    json.expect_format("load-case", 4);
    json.allow_only(
        {"format", "name", "description", "supports", "loads", "prescribed", "gravity", "combines"});
    LoadCase load_case;
    load_case.name = json.at("name").string();
    if (load_case.name.empty()) json.at("name").fail("is empty, where a name is needed");
    if (const auto description = json.find("description")) load_case.description = description->string();
    if (const auto supports = json.find("supports")) load_case.supports = read_supports(*supports);
    const auto loads = elements_of(json, "loads");
    for (std::size_t i = 0; i < loads.size(); ++i) add_any_load(loads[i], {i}, load_case);
    if (const auto prescribed = json.find("prescribed")) load_case.prescribed = read_prescribed(*prescribed);
    load_case.gravity = read_vector(json.find("gravity"), base::kAccelerationLimits);
    for (const JsonReader& share : elements_of(json, "combines")) {
        load_case.combines.push_back(read_share(share));
        if (load_case.combines.back().load_case == load_case.name)
            share.at("load_case").fail("is the load case itself");
    }
    const FormatOfCase needed = oldest_format(load_case);
    json.require_format(needed.name, needed.new_key);
    return load_case;
}

Json load_case_json(const LoadCase& load_case) {
    Json json;
    // The oldest format that can express the load case is written: older programs read it.
    json["format"] = oldest_format(load_case).name;
    json["name"] = load_case.name;
    json["description"] = load_case.description;
    json["supports"] = supports_json(load_case.supports);
    json["loads"] = list_json(std::span(load_case.loads), load_json);
    for (const LoadCase::AreaLoad& load : load_case.area_loads) json["loads"].push_back(area_load_json(load));
    json["prescribed"] = prescribed_json(load_case.prescribed);
    json["gravity"] = vector_json(load_case.gravity);
    if (!load_case.combines.empty()) json["combines"] = list_json(std::span(load_case.combines), share_json);
    return json;
}

LoadCase parse_load_case(std::string_view text, const std::string& source) {
    return read_load_case(JsonReader::from_text(text, source));
}

std::string load_case_text(const LoadCase& load_case) {
    return base::json_text(load_case_json(load_case));
}

void write_load_case(const LoadCase& load_case, const std::filesystem::path& path) {
    base::write_file_atomically(path, load_case_text(load_case));
}

LoadCase read_load_case(const std::filesystem::path& path) {
    return read_load_case(JsonReader::from_file(path));
}

}  // namespace fretwork::simulation
