// SPDX-License-Identifier: GPL-3.0-or-later
// Tile models: those of the framework, and those of Python functions. Tiles with a given stiffness.
#include "core/bind.hpp"
#include "reduction/tile_builds.hpp"

#include <fretwork/base/error.hpp>
#include <fretwork/mechanics/condensation.hpp>
#include <fretwork/reduction/calibration/model_response.hpp>
#include <fretwork/reduction/models/condensed_tile.hpp>
#include <fretwork/reduction/models/corotational_tile.hpp>
#include <fretwork/reduction/models/tile_model.hpp>

namespace fretwork::python {
namespace {

using namespace reduction;

using BoundsGiven = std::variant<std::array<double, 2>, std::function<std::array<double, 2>(const Setting&)>>;

TileParameter make_parameter(std::string name, const BoundsGiven& bounds, TileParameter::Scale scale,
                             std::string unit) {
    TileParameter parameter{std::move(name), std::move(unit), scale, {}};
    parameter.bounds = [bounds](const Setting& setting) {
        const auto* pair = std::get_if<std::array<double, 2>>(&bounds);
        const auto [lower, upper] =
            pair != nullptr ? *pair
                            : std::get<std::function<std::array<double, 2>(const Setting&)>>(bounds)(setting);
        return TileParameter::Bounds{lower, upper};
    };
    return parameter;
}

// NOLINTNEXTLINE(readability-function-size): the keywords of the constructor in Python
TileModel make_model(std::string name, BuildFunction build, std::string summary, Role role,
                     Displacements displacements, Sharing sharing, std::vector<TileParameter> parameters) {
    TileModel model;
    model.name = std::move(name);
    model.summary = std::move(summary);
    model.role = role;
    model.displacements = displacements;
    model.sharing = sharing;
    model.parameters = std::move(parameters);
    model.build = [build = std::move(build)](const TileInput& input) {
        return build_in_python(build, input);
    };
    return model;
}

void bind_input(py::module_& m) {
    py::class_<OwnedTileInput>(m, "TileInput", "The input from which a tile model builds a tile.")
        .def_readonly("layout", &OwnedTileInput::layout, "NodeLayout of the pattern")
        .def_readonly("fan", &OwnedTileInput::fan,
                      "the tile's pattern around a polygon with as many sides as the tile")
        .def_readonly("setting", &OwnedTileInput::setting, "Setting with material, section and joints")
        .def_property_readonly(
            "polygon", [](const OwnedTileInput& self) { return self.polygon; },
            "polygon of the tile, n x 2 floats, m: convex, counterclockwise")
        .def_property_readonly(
            "parameters", [](const OwnedTileInput& self) { return self.parameters; },
            "parameters of the tile model, in the order of its row")
        .def_property_readonly(
            "interface_nodes", [](const OwnedTileInput& self) { return self.fan.interface_node_count; },
            "number of interface nodes, which come side after side, counterclockwise from vertex 0; with one "
            "on each side, node i lies between polygon[i] and polygon[i + 1]")
        .def(
            "frame",
            [](const OwnedTileInput& self) {
                return fan_frame(self.layout, self.fan, self.polygon, self.setting);
            },
            "All beams of the tile as a Frame without supports and loads, in the axes of `polygon`. Its "
            "first `interface_nodes` nodes are the interface nodes.");
    py::class_<TileStructure, std::shared_ptr<TileStructure>>(m, "TileStructure",
                                                              "A tile as a tile model builds it.")
        .def_property_readonly(
            "inner_nodes",
            [](const TileStructure& self) {
                const auto places = self.inner_nodes();
                return std::vector<Eigen::Vector3d>(places.begin(), places.end());
            },
            "n x 3 floats, m, in the tile's own axes");
}

void bind_parameter(py::module_& m) {
    bind_enum<TileParameter::Scale>(m);
    py::class_<TileParameter>(m, "TileParameter", "One parameter of a tile model.")
        .def(py::init(&make_parameter), "name"_a, "bounds"_a, "scale"_a = TileParameter::Scale::Linear,
             "unit"_a = "", "`bounds` of a calibration: a pair, or a function of the setting.")
        .def_property_readonly("name", [](const TileParameter& self) { return self.name; })
        .def_property_readonly("unit", [](const TileParameter& self) { return self.unit; })
        .def_property_readonly("scale", [](const TileParameter& self) { return self.scale; })
        .def(
            "bounds",
            [](const TileParameter& self, const Setting& setting) {
                const auto bounds = self.bounds(setting);
                return std::pair(bounds.lower, bounds.upper);
            },
            "setting"_a, "The smallest and the largest value.");
}

void bind_model(py::module_& m) {
    bind_enum<Displacements>(m);
    bind_enum<Role>(m);
    bind_enum<Sharing>(m);
    bind_parameter(m);
    py::class_<TileModel>(
        m, "TileModel",
        "A tile model, which turns a painted tile into elements between its interface nodes: a row of the "
        "catalogue, or your own.\n\n>>> import fretwork as fw\n>>> def build(tile):\n...     return 0.5 * "
        "fw.condensed_frame(tile.frame(), tile.interface_nodes)\n>>> soft = fw.TileModel('soft', build, "
        "summary='half as stiff')\n>>> soft.name\n'soft'\n")
        .def(py::init(&make_model), "name"_a, "build"_a, py::kw_only(), "summary"_a = "",
             "role"_a = Role::Reduced, "displacements"_a = Displacements::Small, "sharing"_a = Sharing::None,
             "parameters"_a = std::vector<TileParameter>{},
             "build(tile: TileInput) returns the stiffness of the tile's n interface nodes (6n x 6n, "
             "symmetric, SI, "
             "rows ux uy uz rx ry rz of each node; it must not resist rigid motions), or a TileStructure: "
             "corotational_tile(nodes, stiffness) for a model of displacements='large'. With "
             "sharing='congruent' congruent tiles are built once, in their own axes.")
        .def_property_readonly("name", [](const TileModel& self) { return self.name; })
        .def_property_readonly("summary", [](const TileModel& self) { return self.summary; })
        .def_property_readonly("role", [](const TileModel& self) { return self.role; })
        .def_property_readonly("displacements", [](const TileModel& self) { return self.displacements; })
        .def_property_readonly("sharing", [](const TileModel& self) { return self.sharing; })
        .def_property_readonly("parameters", [](const TileModel& self) { return self.parameters; })
        .def("__repr__", [](const TileModel& self) { return "<TileModel " + self.name + ">"; });
    m.def(
        "tile_models", [] { return tile_models(); }, "The built-in tile models.");
    m.def(
        "find_tile_model",
        [](std::string_view name, const std::optional<std::vector<TileModel>>& models) {
            return TileModel(find_tile_model(name, models_or_all(models)));
        },
        "name"_a, "models"_a = py::none(), "The row with this name among these rows and the built-in rows.");
    m.def("parameter_index", &parameter_index, "model"_a, "name"_a);
}

/// A tile in the setting's polygon.
struct TileCase {
    const pattern::NodeLayout& layout;
    const pattern::Pattern& pattern;
    const Setting& setting;
    const std::vector<double>& parameters;
};

/// Calls answer(tile) for a tile of a model. Checks the input.
template <class Answer>
auto ask_model(const ModelOrName& given, const TileCase& tile, const Answer& answer) {
    check(tile.layout, tile.pattern);
    tile.setting.validate();
    const TileModel model = model_of(given);
    if (tile.parameters.size() != model.parameters.size())
        throw base::InputError("tile model " + model.name + " has " +
                               std::to_string(model.parameters.size()) + " parameters, and " +
                               std::to_string(tile.parameters.size()) + " were given");
    return answer(ModelTile(model, tile.layout, tile.pattern, tile.setting));
}

/// The given number of interface nodes, which are the first nodes of a frame. Throws InputError if the number
/// is below 1, or if the frame has fewer nodes.
int checked_interface(const mechanics::Frame& frame, int interface_nodes) {
    if (interface_nodes < 1 || interface_nodes > std::ssize(frame.nodes))
        throw base::InputError("the frame has " + std::to_string(frame.nodes.size()) + " nodes, and " +
                               std::to_string(interface_nodes) + " of them are to be interface nodes");
    return interface_nodes;
}

void bind_structures(py::module_& m) {
    bind_enum<TileBeams>(m);
    m.def(
        "condensed_frame",
        [](const mechanics::Frame& tile, int interface_nodes) {
            return condensed_frame(tile, checked_interface(tile, interface_nodes));
        },
        "tile"_a, "interface_nodes"_a,
        "The linear stiffness of a tile's frame, condensed onto its first `interface_nodes` nodes: 6n x 6n "
        "floats, SI.");
    m.def(
        "stiffness_tile",
        [](const Eigen::MatrixXd& stiffness) {
            return std::const_pointer_cast<TileStructure>(stiffness_tile(stiffness));
        },
        "stiffness"_a, "A tile given by its stiffness (6n x 6n) for small displacements.");
    m.def(
        "beam_tile",
        [](const mechanics::Frame& frame, int interface_nodes, TileBeams beams) {
            return std::const_pointer_cast<TileStructure>(
                beam_tile(frame, checked_interface(frame, interface_nodes), beams));
        },
        "frame"_a, "interface_nodes"_a, "beams"_a = TileBeams::Substitutes, "A tile of beams.");
    m.def(
        "corotational_tile",
        [](const mechanics::Frame& tile, int interface_nodes) {
            return std::const_pointer_cast<TileStructure>(
                corotational_tile(tile, checked_interface(tile, interface_nodes)));
        },
        "tile"_a, "interface_nodes"_a,
        "A tile that may move and turn by any amount, with axes that follow it.");
    m.def(
        "corotational_tile",
        [](std::vector<Eigen::Vector3d> nodes, Eigen::MatrixXd stiffness) {
            return std::const_pointer_cast<TileStructure>(corotational_tile(
                mechanics::CorotationalBody::Parts{std::move(nodes), std::move(stiffness)}));
        },
        "nodes"_a, "stiffness"_a,
        "A corotational tile with given interface nodes (n x 3, m) and a symmetric stiffness (6n x 6n, SI). "
        "Raises InputError if the stiffness resists a rigid motion.");
}

void bind_answers(py::module_& m) {
    m.def(
        "tile_stiffness",
        [](const ModelOrName& model, const pattern::NodeLayout& layout, const pattern::Pattern& pattern,
           const Setting& setting, const std::vector<double>& parameters) {
            const py::gil_scoped_release released;
            return ask_model(model, {layout, pattern, setting, parameters}, [&](const ModelTile& tile) {
                const auto interface_nodes =
                    setting.sides * static_cast<int>(layout.interface_nodes().size());
                return mechanics::condense(assemble(tile.parts(parameters)),
                                           mechanics::first_nodes(interface_nodes));
            });
        },
        "model"_a, "layout"_a, "pattern"_a, "setting"_a, "parameters"_a = std::vector<double>{},
        "The stiffness of a tile in the setting's polygon, condensed onto its n interface nodes: 6n x 6n "
        "floats.");
    m.def(
        "model_displacements",
        [](const ModelOrName& model, const pattern::NodeLayout& layout, const pattern::Pattern& pattern,
           const Setting& setting, const std::vector<double>& parameters) {
            const py::gil_scoped_release released;
            return ask_model(model, {layout, pattern, setting, parameters},
                             [&](const ModelTile& tile) { return tile.displacements(parameters); });
        },
        "model"_a, "layout"_a, "pattern"_a, "setting"_a, "parameters"_a = std::vector<double>{},
        "The linear displacements of a tile under each scenario at 1 N: n x 6 arrays.");
    m.def(
        "model_responses",
        [](const ModelOrName& model, const pattern::NodeLayout& layout, const pattern::Pattern& pattern,
           const Setting& setting, const std::vector<double>& parameters, const py::object& progress) {
            return run_long(progress, [&](const base::Control& control) {
                return ask_model(model, {layout, pattern, setting, parameters},
                                 [&](const ModelTile& tile) { return tile.responses(parameters, control); });
            });
        },
        "model"_a, "layout"_a, "pattern"_a, "setting"_a, "parameters"_a = std::vector<double>{},
        "progress"_a = py::none(),
        "The nonlinear responses of a tile model, in the form of compute_responses().");
}

}  // namespace

void bind_tile_models(py::module_& m) {
    bind_input(m);
    bind_model(m);
    bind_structures(m);
    bind_answers(m);
}

}  // namespace fretwork::python
