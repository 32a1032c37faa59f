// SPDX-License-Identifier: GPL-3.0-or-later
// Settings and scenarios, responses of patterns, and their effective properties.
#include "core/bind.hpp"

#include <fretwork/base/error.hpp>
#include <fretwork/reduction/effective_properties.hpp>
#include <fretwork/reduction/linear_response.hpp>
#include <fretwork/reduction/response.hpp>
#include <fretwork/reduction/scenarios/joints.hpp>
#include <fretwork/reduction/scenarios/setting_file.hpp>
#include <fretwork/reduction/unit_displacements.hpp>

namespace fretwork::python {
namespace {

using namespace reduction;

void bind_scenarios(py::module_& m) {
    Record<Scenario> scenario(m, "Scenario", "A standard load case of one tile in the reference hexagon.");
    Record<Scenario::Support>(scenario.type(), "Support", "The support of an interface node.")
        .field("interface_node", &Scenario::Support::interface_node, "")
        .field("fixed", &Scenario::Support::fixed, "names of components")
        .done();
    Record<Scenario::Load>(scenario.type(), "Load", "A load on an interface node, for a magnitude of 1 N.")
        .field("interface_node", &Scenario::Load::interface_node, "")
        .field("force", &Scenario::Load::force, "3 floats, N")
        .field("moment", &Scenario::Load::moment, "3 floats, N m")
        .done();
    scenario.field("name", &Scenario::name, "")
        .field("description", &Scenario::description, "")
        .field("weight", &Scenario::weight, "w_k of Eq. (8)")
        .field("max_magnitude", &Scenario::max_magnitude, "N")
        .field("supports", &Scenario::supports, "")
        .field("loads", &Scenario::loads, "")
        .done();
    m.def(
        "paper_scenarios", [] { return paper_scenarios(); },
        "The five scenarios of the paper: axial, shear, bending, dome, saddle.");
    m.def("spread_over_sides", &spread_over_sides, "scenario"_a, "nodes_a_side"_a,
          "The scenario for a tile with several interface nodes on each side.");
    bind_files<Scenario>(
        m, "scenario",
        {[](std::string_view text, const std::string& source) { return parse_scenario(text, source); },
         &scenario_text, &read_scenario, &write_scenario});
}

void bind_setting(py::module_& m) {
    bind_enum<SamplePolicy>(m);
    bind_enum<Joints>(m);
    Record<TileMaterial>(m, "TileMaterial", "Material and section of the beams of a tile.")
        .field("section", &TileMaterial::section, "")
        .field("material", &TileMaterial::material, "")
        .done();
    Record<Setting>(m, "Setting", "Everything that a response depends on besides its pattern.")
        .field("material", &Setting::material, "")
        .field("strength", &Setting::strength,
               "strength of the material, Pa: the stress that it bears; or None")
        .field("section", &Setting::section, "")
        .field("tile_side", &Setting::tile_side, "side of the regular polygon, m")
        .field("sides", &Setting::sides, "")
        .field("scenarios", &Setting::scenarios, "")
        .field("divisions", &Setting::divisions, "number of elements of each beam in responses")
        .field("magnitudes", &Setting::magnitudes, "number of magnitudes of each scenario")
        .field("sample_policy", &Setting::sample_policy, "")
        .field("joints", &Setting::joints, "")
        .done()
        .def("validate", &Setting::validate, "source"_a = "setting",
             "Check the setting. Raises InputError if a value is invalid.");
    m.def("made_setting", &made_setting,
          "The paper's setting with stiff joints, for surfaces that are made, whose bars merge where they "
          "meet.");
    m.def("find_setting", &find_setting, "name_or_path"_a,
          "The setting named 'paper' or 'made' or, for another text, the setting in the file with this path. "
          "Raises InputError.");
    m.def("setting_name", &setting_name, "setting"_a,
          "The name of a setting: 'paper', 'made', or 'own' for any other setting.");
    m.def("paper_setting", &paper_setting,
          "The paper's setting, with two elements for each beam.\n\n>>> import fretwork\n>>> setting = "
          "fretwork.paper_setting()\n>>> setting.material.young_modulus\n1000000000.0\n>>> "
          "setting.material.young_modulus = 2e9\n>>> setting == fretwork.paper_setting()\nFalse\n");
    bind_files<Setting>(
        m, "setting",
        {[](std::string_view text, const std::string& source) { return parse_setting(text, source); },
         &setting_text, &read_setting, &write_setting});
    m.def("without_stresses", &without_stresses, "setting"_a,
          "The setting without the strength and the section's shape, on which no response depends.");
    m.def("setting_difference", &setting_difference, "wanted"_a, "present"_a,
          "The first difference between two settings, in one line, or ''.");
    m.def("warnings_about", py::overload_cast<const Setting&>(&reduction::warnings_about), "setting"_a,
          "Warnings about values that look like errors of units, one line each.");
}

void bind_joints(py::module_& m) {
    Record<BarPlace>(m, "BarPlace", "A bar between two nodes.")
        .field("length", &BarPlace::length, "length of the centreline, m")
        .field("joint_reach", &BarPlace::joint_reach, "joint reach from joint_reaches(), in widths of a bar")
        .done();
    m.def("bar_of", &bar_of, "setting"_a, "place"_a,
          "The section and material of the beam that models a bar.");
    m.def(
        "joint_reaches",
        [](const pattern::Fan& fan, const std::vector<geometry::Point2>& places) {
            if (places.size() != fan.nodes.size())
                throw base::InputError("the fan has " + std::to_string(fan.nodes.size()) +
                                       " nodes, and there are " + std::to_string(places.size()) + " places");
            return joint_reaches(fan, places);
        },
        "fan"_a, "places"_a, "The joint reach of each edge, in widths of a bar.");
}

/// Refuse displacements that cannot be those of a tile in the setting. The setting does not say how many
/// interface nodes a side has.
void check_unit_displacements(const UnitDisplacements& model, const Setting& setting) {
    if (model.size() != setting.scenarios.size())
        throw base::InputError("there are displacements of " + std::to_string(model.size()) +
                               " scenarios, and the setting has " + std::to_string(setting.scenarios.size()));
    for (std::size_t s = 0; s < model.size(); ++s) {
        const Eigen::Index rows = model[s].rows();
        if (rows > 0 && rows % setting.sides == 0 && rows == model.front().rows()) continue;
        throw base::InputError("the displacements of scenario '" + setting.scenarios[s].name + "' have " +
                               std::to_string(rows) +
                               " rows, where all scenarios need the same multiple of " +
                               std::to_string(setting.sides) + " rows, one for each interface node");
    }
}

void bind_responses(py::module_& m) {
    Record<Response> response(
        m, "Response",
        "The displacements of a pattern's interface nodes under one scenario, at its magnitudes.");
    Record<Response::Sample>(response.type(), "Sample", "The displacements under one magnitude.")
        .constant("step", &Response::Sample::step, "k")
        .constant("magnitude", &Response::Sample::magnitude, "N")
        .constant("displacements", &Response::Sample::displacements,
                  "n x 6 floats, one row for each interface node; zeros if not converged")
        .constant("converged", &Response::Sample::converged, "")
        .constant("stable", &Response::Sample::stable, "")
        .constant("limit_load", &Response::Sample::limit_load,
                  "True if the equilibrium path turns back before this magnitude")
        .constant("discretization_error", &Response::Sample::discretization_error,
                  "estimated error, a share, or None")
        .done();
    response.constant("scenario", &Response::scenario, "").constant("samples", &Response::samples, "").done();
    Record<ResponseOptions>(m, "ResponseOptions", "Options of compute_responses().")
        .field("estimate_error", &ResponseOptions::estimate_error,
               "True: fill Response.Sample.discretization_error")
        .done();
    m.def(
        "compute_responses",
        [](const pattern::NodeLayout& layout, const pattern::Pattern& pattern, const Setting& setting,
           const py::kwargs& named) {
            check(layout, pattern);
            return Keywords<ResponseOptions>(named).run(
                [&](const auto& options) { return compute_responses(layout, pattern, setting, options); });
        },
        "layout"_a, "pattern"_a, "setting"_a,
        "The nonlinear responses of a pattern, one for each scenario of the setting.\n\n"
        "Options: ResponseOptions, progress\n\n"
        ">>> import fretwork as fw\n"
        ">>> layout = fw.paper_layout()\n"
        ">>> pattern = fw.parse_pattern_id(layout, '0-1+1-6')\n"
        ">>> responses = fw.compute_responses(layout, pattern, fw.paper_setting())\n"
        ">>> [response.scenario for response in responses]\n"
        "['axial', 'shear', 'bending', 'dome', 'saddle']\n"
        ">>> responses[0].samples[-1].displacements.shape\n"
        "(6, 6)\n");
    m.def(
        "linear_responses",
        [](const UnitDisplacements& model, const Setting& setting) {
            setting.validate();
            check_unit_displacements(model, setting);
            return linear_responses(model, setting);
        },
        "model"_a, "setting"_a,
        "The responses of a linear model at the setting's magnitudes, from its displacements at 1 N.");
    m.def(
        "unit_displacements",
        [](const Eigen::MatrixXd& stiffness, const Setting& setting) {
            setting.validate();
            const Eigen::Index side = 6 * setting.sides;
            if (stiffness.rows() == 0 || stiffness.rows() != stiffness.cols() || stiffness.rows() % side != 0)
                throw base::InputError("a stiffness of interface nodes on " + std::to_string(setting.sides) +
                                       " sides is square and has a multiple of " + std::to_string(side) +
                                       " rows, not " + std::to_string(stiffness.rows()) + " x " +
                                       std::to_string(stiffness.cols()));
            return unit_displacements(stiffness, setting);
        },
        "stiffness"_a, "setting"_a,
        "The displacements of a tile with this stiffness (6n x 6n) under each scenario at 1 N: n x 6 "
        "arrays.");
}

void bind_tile_frames(py::module_& m) {
    m.def(
        "pattern_frame",
        [](const pattern::NodeLayout& layout, const pattern::Pattern& pattern, const Setting& setting) {
            check(layout, pattern);
            setting.validate();
            return pattern_frame(layout, pattern, setting);
        },
        "layout"_a, "pattern"_a, "setting"_a,
        "The pattern's full model in the setting's polygon, without supports and loads. Node i of the frame "
        "is interface node i.");
    m.def(
        "fan_frame",
        [](const pattern::NodeLayout& layout, const pattern::Fan& fan, const geometry::Polygon& polygon,
           const Setting& setting) {
            for (const auto& node : fan.nodes)
                checked_index(node.layout_node.value, layout.nodes().size(), "node of this layout");
            return fan_frame(layout, fan, polygon, setting);
        },
        "layout"_a, "fan"_a, "polygon"_a, "setting"_a, "The beams of a fan in a convex polygon (n x 2, m).");
    m.def(
        "scenario_frame",
        [](const mechanics::Frame& tile, const Scenario& scenario) {
            for (const auto* nodes : {&scenario.supports})
                for (const auto& held : *nodes) checked_index(held.interface_node, tile.nodes.size(), "node");
            for (const auto& load : scenario.loads)
                checked_index(load.interface_node, tile.nodes.size(), "node");
            return scenario_frame(tile, scenario);
        },
        "tile"_a, "scenario"_a,
        "A tile's frame with the supports and loads of a scenario at its largest magnitude.");
}

void bind_properties(py::module_& m) {
    Record<EffectiveProperties>(
        m, "EffectiveProperties",
        "The stiffness and mass of the thin plate that is equivalent to an infinite surface of one pattern.")
        .constant("A", &EffectiveProperties::A, "3 x 3 floats, N/m: from strains to membrane forces (Voigt)")
        .constant("D", &EffectiveProperties::D, "3 x 3 floats, N m: from curvatures to moments (Voigt)")
        .constant("mass_per_area", &EffectiveProperties::mass_per_area, "kg/m^2")
        .done();
    m.def(
        "effective_properties",
        [](const pattern::NodeLayout& layout, const pattern::Pattern& pattern, const Setting& setting) {
            check(layout, pattern);
            setting.validate();
            return effective_properties(layout, pattern, setting);
        },
        "layout"_a, "pattern"_a, "setting"_a, "Homogenize a pattern in the setting's regular polygon.");
    m.def("directional_stiffness", &directional_stiffness, "tensor"_a, "angle"_a,
          "The stiffness of a strip along `angle` (rad), which may contract freely across that direction.");
    m.def(
        "property_values",
        [](const EffectiveProperties& properties) {
            std::vector<NamedValue> values;
            for (const auto& [name, value] : property_values(properties)) values.push_back({name, value});
            return values;
        },
        "properties"_a, "The named values that libraries store.");
}

}  // namespace

void bind_settings(py::module_& m) {
    bind_scenarios(m);
    bind_setting(m);
    bind_joints(m);
    bind_responses(m);
    bind_tile_frames(m);
    bind_properties(m);
}

}  // namespace fretwork::python
