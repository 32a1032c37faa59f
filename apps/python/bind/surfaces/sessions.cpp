// SPDX-License-Identifier: GPL-3.0-or-later
// Sessions: a surface under a load case that is edited and solved again and again.
#include "core/bind.hpp"
#include "reduction/library_object.hpp"
#include "reduction/tile_builds.hpp"
#include "surfaces/session_object.hpp"

#include <fretwork/base/error.hpp>
#include <fretwork/simulation/derivatives/sensitivity.hpp>
#include <fretwork/simulation/results/result_subject.hpp>
#include <fretwork/simulation/session.hpp>
#include <fretwork/simulation/simulate.hpp>
#include <fretwork/simulation/stages.hpp>

namespace fretwork::python {
namespace {

using namespace simulation;
using tiling::TileIndex;
using Tiles = std::vector<TileIndex>;

using SessionClass = py::class_<SessionObject, SessionPointer>;

/// Keywords of simulations, and their tile models.
struct SimulationKeywords {
    std::vector<reduction::TileModel> models;
    py::object progress;
    SimulationOptions options{};

    explicit SimulationKeywords(const py::kwargs& named) {
        py::dict others(named.attr("copy")());
        models = taken_models(others);
        progress = taken(others, "progress");
        fill_record(py::cast(&options, py::return_value_policy::reference), others);
        options.models = models;
    }
};

/// A library as the source of calibrations of patterns that are painted later.
CalibrationSource source_of(const LibraryPointer& library) {
    if (!library) return {};
    return [library](const std::string& id) { return library->use()->best_calibrations(id); };
}

SessionPointer make_session(const Surface& surface, const LoadCase& load_case, const LibraryPointer& library,
                            const py::kwargs& named) {
    SimulationKeywords keywords(named);
    surface.setting.validate();
    Session session(surface, load_case, keywords.options, source_of(library));
    return std::make_shared<SessionObject>(OwnedSession{std::move(keywords.models), std::move(session)},
                                           "session");
}

SurfaceResult solve_session(SessionObject& self, mechanics::StabilityCheck check, bool with_subject,
                            const py::object& progress) {
    const auto use = self.use();
    return run_long(progress, [&](const base::Control& control) {
        SurfaceResult result = use->session.solve(control, check);
        if (with_subject)
            result.subject = result_subject(use->session.surface(), use->session.load_case(),
                                            use->session.options(), use->session.full_tiles());
        return result;
    });
}

void bind_options(py::module_& m) {
    bind_enum<Analysis>(m);
    Record<SimulationOptions>(m, "SimulationOptions", "Options of a simulation.")
        .field("model", &SimulationOptions::model,
               "tile model of the tiles without their own; or 'mixed:SHARE'")
        .field("analysis", &SimulationOptions::analysis, "theory; of the model: as stated in the model's row")
        .field("estimate_error", &SimulationOptions::estimate_error,
               "True: estimate the error of the beams' divisions")
        .field("estimate_model_error", &SimulationOptions::estimate_model_error,
               "True: estimate the error of reduced models")
        .field("load_steps", &SimulationOptions::load_steps, "number of results at equal shares of the load")
        .field("branch", &SimulationOptions::branch, "equilibria to follow when the path becomes unstable")
        .field("vibration_modes", &SimulationOptions::vibration_modes, "for simulate() only")
        .field("buckling_modes", &SimulationOptions::buckling_modes, "for simulate() only")
        .field("estimate_linear_range", &SimulationOptions::estimate_linear_range,
               "True: estimate the error of linear solutions")
        .field("threads", &SimulationOptions::threads,
               "number of threads; 0: one for each processor; no bit of the result depends on the number")
        .done();
    bind_enum<mechanics::FactorChange>(m);
    bind_enum<mechanics::StartingPoint>(m);
    bind_enum<mechanics::StabilityCheck>(m);
    Record<TileDeformation>(m, "TileDeformation", "The deformation of a tile.")
        .constant("energy", &TileDeformation::energy, "J")
        .constant("rotation", &TileDeformation::rotation,
                  "largest rotation of a node relative to the tile's corotating axes, rad")
        .done(Made::ByFunctions);
}

SessionClass bind_session(py::module_& m) {
    SessionClass type(
        m, "Session",
        "A surface under a load case that is edited and solved repeatedly, with all data kept that an edit "
        "leaves valid. Only one thread at a time may use a session; different sessions may be solved at "
        "once.\n\n>>> import fretwork as fw\n>>> square = fw.make_outline([[0, 0], [0.2, 0], [0.2, 0.2], [0, "
        "0.2]])\n>>> project, _ = fw.make_project(square, patterns='0-1+1-6', edge_length=0.025)\n>>> case = "
        "fw.LoadCase(name='tip',\n...     supports=[fw.LoadCase.Support(fw.NodesAtSide('left'), "
        "'all')],\n...     loads=[fw.LoadCase.Load(fw.NodesAtSide('right'), force=[0, 0, -0.001])])\n>>> "
        "session = fw.Session(fw.make_surface(project), case, model='corotational')\n>>> before = "
        "session.solve().largest_displacement\n>>> session.paint([0, 1, 2], '0-5+5-6')\n>>> "
        "session.solve().largest_displacement < before\nTrue\n");
    Record<Session::Report>(type, "Report",
                            "The data that the last solution computed, and the data that it reused.")
        .constant("tiles_built", &Session::Report::tiles_built,
                  "number of tiles built; shared tiles count once")
        .constant("factors", &Session::Report::factors, "effect on the factors of a linear solution")
        .constant("starting_point", &Session::Report::starting_point,
                  "starting point of a nonlinear solution")
        .done(Made::ByFunctions);
    type.def(py::init(&make_session), "surface"_a, "load_case"_a, "library"_a = py::none(),
             "`library` has the calibrations of patterns that are painted later; `models` are your own tile "
             "models in addition to the built-in models.\n\nOptions: SimulationOptions, models\n")
        .def_property_readonly(
            "surface", [](SessionObject& self) { return self.use()->session.surface(); }, "a copy")
        .def_property_readonly(
            "load_case", [](SessionObject& self) { return self.use()->session.load_case(); }, "a copy")
        .def_property_readonly("last_report",
                               [](SessionObject& self) { return self.use()->session.last_report(); })
        .def_property_readonly(
            "full_tiles", [](SessionObject& self) { return self.use()->session.full_tiles(); },
            "The tiles that a mixed model has put in full, after solve().");
    return type;
}

void bind_edits(SessionClass& type) {
    type.def(
            "paint",
            [](SessionObject& self, const Tiles& tiles, const std::string& pattern) {
                self.use()->session.paint(tiles, pattern);
            },
            "tiles"_a, "pattern"_a, "Paint tiles with a pattern, given by its id.")
        .def(
            "turn",
            [](SessionObject& self, const Tiles& tiles, int vertices) {
                self.use()->session.turn(tiles, vertices);
            },
            "tiles"_a, "vertices"_a, "Turn the patterns of tiles.")
        .def(
            "set_tile_model",
            [](SessionObject& self, const Tiles& tiles, const std::string& model) {
                self.use()->session.set_tile_model(tiles, model);
            },
            "tiles"_a, "model"_a, "Give tiles a tile model of their own; '' removes it.")
        .def(
            "set_model",
            [](SessionObject& self, const std::string& model) { self.use()->session.set_model(model); },
            "model"_a)
        .def(
            "set_setting",
            [](SessionObject& self, const reduction::Setting& setting) {
                self.use()->session.set_setting(setting);
            },
            "setting"_a, "Change the material, the section or the scenarios.")
        .def(
            "set_calibrations",
            [](SessionObject& self, std::vector<std::vector<reduction::Calibration>> given) {
                self.use()->session.set_calibrations(std::move(given));
            },
            "calibrations"_a, "Change the calibrations, for each pattern of the surface in turn.")
        .def(
            "set_load_case",
            [](SessionObject& self, const LoadCase& load_case) {
                self.use()->session.set_load_case(load_case);
            },
            "load_case"_a)
        .def(
            "set_support",
            [](SessionObject& self, std::size_t entry, const LoadCase::Support& support) {
                self.use()->session.set_support(entry, support);
            },
            "entry"_a, "support"_a, "Change one entry of the load case, or append one.")
        .def(
            "set_load",
            [](SessionObject& self, std::size_t entry, const LoadCase::Load& load) {
                self.use()->session.set_load(entry, load);
            },
            "entry"_a, "load"_a, "Change one entry of the load case, or append one.")
        .def(
            "set_prescribed",
            [](SessionObject& self, std::size_t entry, const LoadCase::PrescribedDisplacement& given) {
                self.use()->session.set_prescribed(entry, given);
            },
            "entry"_a, "displacement"_a, "Change one entry of the load case, or append one.");
}

void bind_solutions(SessionClass& type) {
    type.def("solve", &solve_session, "check"_a = mechanics::StabilityCheck::Made, "subject"_a = false,
             "progress"_a = py::none(),
             "The equilibrium of the present surface. With `subject`, the result has its subject, which "
             "files and compare() need.")
        .def(
            "solve_adjoint",
            [](SessionObject& self, const Eigen::MatrixXd& rows, const py::object& progress) {
                const auto use = self.use();
                return run_long(progress, [&](const base::Control& control) {
                    return use->session.solve_adjoint(rows, control);
                });
            },
            "rows"_a, "progress"_a = py::none(),
            "The linear displacements under nodal loads, one column each (6n rows), with nothing prescribed: "
            "the "
            "adjoint of a linear solution.")
        .def(
            "sensitivity",
            [](SessionObject& self, const mechanics::NodeValues& gradient, const py::object& progress) {
                const auto use = self.use();
                return run_long(progress, [&](const base::Control& control) {
                    return use->session.sensitivity(gradient, control);
                });
            },
            "gradient"_a, "progress"_a = py::none(),
            "The derivatives of a function J of the displacements at the equilibrium of the last solve(), "
            "linear or nonlinear. `gradient`: n x 6 floats, one row for each node of the result, the "
            "derivatives of J with respect to displacements (1/m) and rotation vectors (1/rad). Raises "
            "InputError if there is no such equilibrium, as after an edit or with several load steps.")
        .def(
            "energy_gradient",
            [](SessionObject& self, const SurfaceResult& result) {
                const auto use = self.use();
                return use->session.energy_gradient(checked(*use, result));
            },
            "result"_a,
            "The gradient of result.solution.energy with respect to displacements and rotation vectors: n x "
            "6 floats (N, N m).")
        .def(
            "tile_deformations",
            [](SessionObject& self, const SurfaceResult& result) {
                const auto use = self.use();
                return use->session.tile_deformations(checked(*use, result));
            },
            "result"_a, "The deformation of each tile; zero for tiles made of beams.");
}

void bind_simulate(py::module_& m) {
    m.def(
        "simulate",
        [](const Surface& surface, const LoadCase& load_case, const py::kwargs& named) {
            SimulationKeywords keywords(named);
            surface.setting.validate();
            return run_long(keywords.progress, [&](const base::Control& control) {
                return simulate(surface, load_case, keywords.options, control);
            });
        },
        "surface"_a, "load_case"_a,
        "Simulate a surface under a load case: a session that is used once.\n\n"
        "Options: SimulationOptions, models, progress\n");
    m.def(
        "simulate_stages",
        [](const Surface& surface, const LoadCase& supports, const std::vector<LoadCase>& cases,
           const std::vector<LoadStage>& stages, const py::kwargs& named) {
            SimulationKeywords keywords(named);
            surface.setting.validate();
            return run_long(keywords.progress, [&](const base::Control& control) {
                return simulate_stages(surface, {supports, cases, stages}, keywords.options, control);
            });
        },
        "surface"_a, "supports"_a, "cases"_a, "stages"_a,
        "Simulate load stages, one after the other, each from the equilibrium of the stage "
        "before.\n\nOptions: SimulationOptions, models, progress\n");
    m.def(
        "result_subject",
        [](const Surface& surface, const LoadCase& load_case, const py::kwargs& named) {
            SimulationKeywords keywords(named);
            return result_subject(surface, load_case, keywords.options);
        },
        "surface"_a, "load_case"_a,
        "The subject of a result of this surface under this load case.\n\nOptions: SimulationOptions, "
        "models\n");
}

}  // namespace

void bind_sessions(py::module_& m) {
    bind_options(m);
    SessionClass type = bind_session(m);
    bind_edits(type);
    bind_solutions(type);
    bind_simulate(m);
}

}  // namespace fretwork::python
