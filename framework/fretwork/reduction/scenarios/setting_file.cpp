// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/files/file.hpp>
#include <fretwork/base/named.hpp>
#include <fretwork/mechanics/internal/section_json.hpp>
#include <fretwork/reduction/detail/scenario_json.hpp>
#include <fretwork/reduction/internal/setting_json.hpp>
#include <fretwork/reduction/scenarios/setting_file.hpp>

#include <algorithm>
#include <array>

namespace fretwork::reduction {
namespace {

using base::Json;
using base::JsonReader;

struct NamedSetting {
    std::string_view name;
    Setting (*make)();
};
constexpr std::array<NamedSetting, 2> kNamedSettings = {{{"paper", paper_setting}, {"made", made_setting}}};

mechanics::Material read_material(const JsonReader& json) {
    json.allow_only({"young_modulus", "poisson_ratio", "density", "shear_modulus", "strength"});
    mechanics::Material material;
    material.young_modulus = json.at("young_modulus").positive_number();
    material.poisson_ratio = json.at("poisson_ratio").number();
    if (!(material.poisson_ratio > -1.0 && material.poisson_ratio <= 0.5)) {
        json.at("poisson_ratio").fail("a Poisson's ratio lies above -1 and up to 0.5");
    }
    if (const auto density = json.find("density")) {
        material.density = density->number();
        if (material.density < 0.0) density->fail("a density is not negative");
    }
    if (const auto given = json.find("shear_modulus"))
        material.given_shear_modulus = given->positive_number();
    return material;
}

Scenario named_scenario(const JsonReader& json) {
    const std::string name = json.string();
    return json.located(
        [&] { return base::find_named(name, paper_scenarios(), &Scenario::name, "scenario"); });
}

Scenario read_scenario_entry(const JsonReader& json) {
    if (json.is_string()) return named_scenario(json);
    if (!json.find("use")) return detail::read_scenario(json);
    json.allow_only({"use", "max_magnitude", "weight"});
    Scenario scenario = named_scenario(json.at("use"));
    if (const auto magnitude = json.find("max_magnitude"))
        scenario.max_magnitude = magnitude->positive_number();
    if (const auto weight = json.find("weight")) scenario.weight = weight->positive_number();
    return scenario;
}

void read_choices(const JsonReader& json, Setting& setting) {
    if (const auto sides = json.find("sides"))
        setting.sides = static_cast<int>(sides->integer(3, kMostSides));
    if (const auto count = json.find("divisions")) {
        setting.divisions = static_cast<int>(count->integer(1, kMostBeamDivisions));
    }
    if (const auto count = json.find("magnitudes")) {
        setting.magnitudes = static_cast<int>(count->integer(1, kMostMagnitudes));
    }
    if (const auto branch = json.find("branch")) {
        setting.sample_policy =
            branch->choice({"paper", "stable"}) == "paper" ? SamplePolicy::Paper : SamplePolicy::Stable;
    }
    if (const auto joints = json.find("joints")) setting.joints = read_joints(*joints);
}

/// Checks sides that are chosen for the paper's scenarios: the file has no other place to blame.
void check_sides(const JsonReader& json, const Setting& setting) {
    const auto sides = json.find("sides");
    if (!sides || json.find("scenarios")) return;
    int least = 0;
    for (const Scenario& scenario : setting.scenarios) {
        for (const auto& support : scenario.supports) least = std::max(least, support.interface_node + 1);
        for (const auto& load : scenario.loads) least = std::max(least, load.interface_node + 1);
    }
    if (setting.sides < least)
        sides->fail("is " + sides->text() + ", where the paper's scenarios need at least " +
                    std::to_string(least) + "; fewer sides need \"scenarios\" of their own");
}

/// The strength, which the first format does not have.
std::optional<double> read_strength(const JsonReader& document) {
    const auto material = document.find("material");
    const auto strength = material ? material->find("strength") : std::nullopt;
    if (!strength) return std::nullopt;
    const std::string format = document.at("format").string();
    if (format == "fretwork/setting/1") strength->fail("is not a key of " + format);
    return strength->positive_number();
}

Json material_json(const mechanics::Material& material) {
    Json json = {{"young_modulus", material.young_modulus},
                 {"poisson_ratio", material.poisson_ratio},
                 {"density", material.density}};
    if (material.given_shear_modulus) json["shear_modulus"] = *material.given_shear_modulus;
    return json;
}

/// All values of a setting as JSON, including the values that its file leaves out.
Json comparable_json(const Setting& setting) {
    Json json = setting_json(setting);
    json.erase("format");
    json["joints"] = joints_name(setting.joints);
    return json;
}

/// The value at a pointer as a text; "nothing" if there is no value.
std::string value_text(const Json& json, const Json::json_pointer& pointer) {
    return json.contains(pointer) ? json.at(pointer).dump() : "nothing";
}

}  // namespace

Joints read_joints(const JsonReader& json) {
    return json.choice({"centreline", "stiff"}) == "stiff" ? Joints::Stiff : Joints::Centreline;
}

Setting read_setting(const JsonReader& json) {
    json.expect_format("setting", 3);
    json.allow_only({"format", "material", "section", "tile_side", "sides", "divisions", "magnitudes",
                     "branch", "joints", "scenarios"});
    Setting setting = paper_setting();
    if (const auto material = json.find("material")) setting.material = read_material(*material);
    setting.strength = read_strength(json);
    if (const auto section = json.find("section")) setting.section = mechanics::read_section(*section);
    if (const auto side = json.find("tile_side")) setting.tile_side = side->positive_number();
    read_choices(json, setting);
    if (const auto scenarios = json.find("scenarios")) {
        setting.scenarios.clear();
        for (const JsonReader& entry : scenarios->elements()) {
            setting.scenarios.push_back(read_scenario_entry(entry));
        }
    }
    check_sides(json, setting);
    json.located([&] { setting.validate(""); });
    return setting;
}

Json setting_json(const Setting& setting) {
    Json json = {{"format", setting.strength ? "fretwork/setting/2" : "fretwork/setting/1"},
                 {"material", material_json(setting.material)},
                 {"section", mechanics::section_json(setting.section)},
                 {"tile_side", setting.tile_side},
                 {"sides", setting.sides},
                 {"divisions", setting.divisions},
                 {"magnitudes", setting.magnitudes},
                 {"branch", sample_policy_name(setting.sample_policy)},
                 {"scenarios", Json::array()}};
    // The key is written only for stiff joints, so a setting with centrelines has the same text and
    // hash as before this key existed.
    if (setting.joints != Joints::Centreline) {
        json["format"] = "fretwork/setting/2";
        json["joints"] = joints_name(setting.joints);
    }
    if (mechanics::is_of_newer_format(setting.section)) json["format"] = "fretwork/setting/3";
    for (const Scenario& scenario : setting.scenarios) {
        json["scenarios"].push_back(detail::scenario_json(scenario));
    }
    if (setting.strength) json["material"]["strength"] = *setting.strength;
    return json;
}

Setting read_setting(const std::filesystem::path& path) {
    return read_setting(JsonReader::from_file(path));
}

Setting parse_setting(std::string_view text, std::string source) {
    return read_setting(JsonReader::from_text(text, std::move(source)));
}

Setting find_setting(const std::string& name_or_path) {
    for (const NamedSetting& known : kNamedSettings) {
        if (known.name == name_or_path) return known.make();
    }
    std::error_code unknown;
    if (!std::filesystem::exists(name_or_path, unknown))
        throw base::InputError("setting '" + name_or_path +
                               "': expected paper, made, or the path of a setting file");
    return read_setting(std::filesystem::path(name_or_path));
}

std::string setting_name(const Setting& setting) {
    for (const NamedSetting& known : kNamedSettings) {
        if (setting_difference(known.make(), setting).empty()) return std::string(known.name);
    }
    return "own";
}

void write_setting(const Setting& setting, const std::filesystem::path& path) {
    base::write_file_atomically(path, setting_text(setting));
}

std::string setting_text(const Setting& setting) {
    return base::json_text(setting_json(setting));
}

Setting without_stresses(Setting setting) {
    setting.strength.reset();
    setting.section.shape.reset();
    return setting;
}

std::string setting_difference(const Setting& wanted, const Setting& present) {
    const Json left = comparable_json(without_stresses(wanted));
    const Json right = comparable_json(without_stresses(present));
    const Json patch = Json::diff(right, left);
    if (patch.empty()) return "";
    Json::json_pointer place(patch.front().at("path").get<std::string>());
    if (place.back() == "-") {  // an element after the last one of an array
        place.pop_back();
        place.push_back(std::to_string(right.at(place).size()));
    }
    return place.to_string() + ": " + value_text(left, place) + ", where the library has " +
           value_text(right, place);
}

}  // namespace fretwork::reduction
