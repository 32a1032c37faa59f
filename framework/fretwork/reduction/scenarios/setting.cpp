// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/limits.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/reduction/scenarios/setting.hpp>

#include <array>
#include <cmath>
#include <numbers>
#include <set>

namespace fretwork::reduction {
namespace {

void check_interface_node(const Setting& setting, int node, const std::string& source,
                          const std::string& place) {
    if (node >= 0 && node < setting.sides) return;
    throw base::InputError(source, place,
                           "there is no interface node " + std::to_string(node) + " in a polygon of " +
                               std::to_string(setting.sides) + " sides");
}

/// Check a force or a moment of a load.
void check_components(const std::array<double, 3>& components, const base::Limits& limits,
                      const std::string& source, const std::string& place) {
    for (std::size_t i = 0; i < components.size(); ++i) {
        if (base::is_within(components[i], limits)) continue;
        throw base::InputError(source, place + "/" + std::to_string(i),
                               "is " + base::format_number(components[i]) + ", where " +
                                   base::range_text(limits) + " is needed");
    }
}

void check_loads(const Setting& setting, const Scenario& scenario, const std::string& source,
                 const std::string& place) {
    if (scenario.loads.empty()) throw base::InputError(source, place, "a scenario needs a load");
    for (std::size_t i = 0; i < scenario.loads.size(); ++i) {
        const std::string own = place + "/" + std::to_string(i);
        check_interface_node(setting, scenario.loads[i].interface_node, source, own);
        check_components(scenario.loads[i].force, base::kForceLimits, source, own + "/force");
        check_components(scenario.loads[i].moment, base::kMomentLimits, source, own + "/moment");
    }
}

void check_scenario(const Setting& setting, std::size_t index, const std::string& source) {
    const Scenario& scenario = setting.scenarios[index];
    const std::string place = "/scenarios/" + std::to_string(index);
    if (scenario.name.empty()) throw base::InputError(source, place + "/name", "a scenario needs a name");
    if (!(scenario.weight > 0.0 && std::isfinite(scenario.weight)))
        throw base::InputError(
            source, place + "/weight",
            "is " + base::format_number(scenario.weight) + ", where a number above zero is needed");
    if (!base::is_positive_within(scenario.max_magnitude, base::kForceLimits))
        throw base::InputError(source, place + "/max_magnitude",
                               "is " + base::format_number(scenario.max_magnitude) + ", where " +
                                   base::positive_range_text(base::kForceLimits) + " is needed");
    for (std::size_t i = 0; i < scenario.supports.size(); ++i) {
        check_interface_node(setting, scenario.supports[i].interface_node, source,
                             place + "/held/" + std::to_string(i));
    }
    check_loads(setting, scenario, source, place + "/loads");
}

void check_quantities(const Setting& setting, const std::string& source) {
    const auto require = [&](const char* place, double value, const base::Limits& limits) {
        if (!base::is_positive_within(value, limits))
            throw base::InputError(source, place,
                                   "is " + base::format_number(value) + ", where " +
                                       base::positive_range_text(limits) + " is needed");
    };
    const mechanics::Section& section = setting.section;
    require("/tile_side", setting.tile_side, base::kLengthLimits);
    require("/section/area", section.area, base::kAreaLimits);
    require("/section/I2", section.I2, base::kSecondMomentLimits);
    require("/section/I3", section.I3, base::kSecondMomentLimits);
    require("/section/J", section.J, base::kSecondMomentLimits);
    if (section.shear_area2) require("/section/shear_area2", *section.shear_area2, base::kAreaLimits);
    if (section.shear_area3) require("/section/shear_area3", *section.shear_area3, base::kAreaLimits);
    const mechanics::Material& material = setting.material;
    require("/material/young_modulus", material.young_modulus, base::kModulusLimits);
    if (material.given_shear_modulus)
        require("/material/shear_modulus", *material.given_shear_modulus, base::kModulusLimits);
    if (setting.strength) require("/material/strength", *setting.strength, base::kModulusLimits);
    if (material.density != 0.0) require("/material/density", material.density, base::kDensityLimits);
}

}  // namespace

std::vector<std::string> warnings_about(const Setting& setting) {
    constexpr double kSoftest = 1e4;  // Pa; foams are stiffer
    constexpr double kWeakest = 1e3;  // Pa
    constexpr double kLargest = 10;   // m
    std::vector<std::string> doubts;
    const auto doubt = [&](const char* what, double value, const char* why) {
        doubts.push_back(what + base::format_number(value) + why);
    };
    if (setting.material.young_modulus < kSoftest)
        doubt("Young's modulus is ", setting.material.young_modulus,
              " Pa, less than any solid has (2 GPa is 2e9)");
    if (setting.strength && *setting.strength < kWeakest)
        doubt("the strength is ", *setting.strength, " Pa, less than any solid bears (40 MPa is 4e7)");
    if (setting.tile_side > kLargest) doubt("tiles have sides of ", setting.tile_side, " m (15 mm is 0.015)");
    return doubts;
}

std::string_view sample_policy_name(SamplePolicy policy) {
    return policy == SamplePolicy::Paper ? "paper" : "stable";
}

std::string_view joints_name(Joints joints) {
    return joints == Joints::Centreline ? "centreline" : "stiff";
}

void Setting::validate(const std::string& source) const {
    const auto require = [&](bool makes_sense, const char* place, const std::string& what) {
        if (!makes_sense) throw base::InputError(source, place, what);
    };
    const auto require_count = [&](int count, int least, int most, const char* place) {
        require(count >= least && count <= most, place,
                "a number from " + std::to_string(least) + " to " + std::to_string(most) + " is needed");
    };
    check_quantities(*this, source);
    require(material.poisson_ratio > -1.0 && material.poisson_ratio <= 0.5, "/material/poisson_ratio",
            "a Poisson's ratio lies above -1 and up to 0.5");
    require_count(sides, 3, kMostSides, "/sides");
    require_count(divisions, 1, kMostBeamDivisions, "/divisions");
    require_count(magnitudes, 1, kMostMagnitudes, "/magnitudes");
    require(!scenarios.empty(), "/scenarios", "at least one is needed");
    std::set<std::string> names;
    for (std::size_t i = 0; i < scenarios.size(); ++i) {
        if (!names.insert(scenarios[i].name).second) {
            throw base::InputError(source, "/scenarios/" + std::to_string(i),
                                   "a second scenario is called '" + scenarios[i].name + "'");
        }
        check_scenario(*this, i, source);
    }
}

Setting paper_setting() {
    constexpr double kBarWidth = 0.002;
    constexpr double kCircumdiameter = 0.03 * std::numbers::sqrt3;
    constexpr double kPlaDensity = 1240.0;  // Section 7.3; no response depends on it
    Setting setting;
    setting.material = {.young_modulus = 1e9, .poisson_ratio = 0.3, .density = kPlaDensity};
    setting.section = mechanics::rectangle_section(kBarWidth, kBarWidth);
    setting.tile_side = kCircumdiameter / 2.0;
    setting.scenarios = paper_scenarios();
    return setting;
}

Setting made_setting() {
    Setting setting = paper_setting();
    setting.joints = Joints::Stiff;
    return setting;
}

}  // namespace fretwork::reduction
