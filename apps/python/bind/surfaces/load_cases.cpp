// SPDX-License-Identifier: GPL-3.0-or-later
// Load cases, the nodes that they pick, and stages of loading.
#include "core/bind.hpp"

#include <fretwork/base/error.hpp>
#include <fretwork/simulation/load_cases/combination.hpp>
#include <fretwork/simulation/load_cases/conditions.hpp>
#include <fretwork/simulation/load_cases/load_case_file.hpp>
#include <fretwork/simulation/load_cases/load_case_text.hpp>
#include <fretwork/simulation/load_cases/selection.hpp>
#include <fretwork/simulation/stages.hpp>

namespace fretwork::python {
namespace {

using namespace simulation;

void bind_selections(py::module_& m) {
    bind_enum<Side>(m);
    Record<NodesById>(m, "NodesById", "Interface nodes by their numbers.")
        .field("ids", &NodesById::ids, "")
        .done();
    Record<NodesInBox>(m, "NodesInBox", "All interface nodes in a box, its rim included.")
        .field("box", &NodesInBox::box, "xmin ymin xmax ymax, m")
        .done();
    Record<NodesInCircle>(m, "NodesInCircle", "All interface nodes in a circle, its line included.")
        .field("center", &NodesInCircle::center, "x y, m")
        .field("radius", &NodesInCircle::radius, "above zero, m")
        .done();
    Record<NodesNearest>(m, "NodesNearest", "The interface node nearest to each of some points.")
        .field("points", &NodesNearest::points, "n x 2 floats, m")
        .done();
    Record<NodesAtSide>(m, "NodesAtSide", "The rim nodes along one side of the bounding box.")
        .field("side", &NodesAtSide::side, "")
        .done();
    m.def("select_nodes", &select_nodes, "selection"_a, "tessellation"_a,
          "The numbers of the interface nodes of a selection, ascending.");
}

void bind_entries(const py::object& load_case) {
    Record<LoadCase::Support>(load_case, "Support", "A support of some interface nodes.")
        .field("where", &LoadCase::Support::where, "a selection")
        .field("fixed", &LoadCase::Support::fixed, "names of components: 'all', 'ux uy uz'")
        .done();
    Record<LoadCase::Load>(load_case, "Load", "A load on some interface nodes.")
        .field("where", &LoadCase::Load::where, "a selection")
        .field("force", &LoadCase::Load::force, "3 floats, N")
        .field("moment", &LoadCase::Load::moment, "3 floats, N m")
        .field("amount", &LoadCase::Load::amount,
               "meaning of the values: for each node, for all nodes together, or per metre of the rim")
        .done();
    Record<LoadCase::PrescribedDisplacement>(load_case, "PrescribedDisplacement",
                                             "A displacement with a given value.")
        .field("where", &LoadCase::PrescribedDisplacement::where, "a selection")
        .field("dof", &LoadCase::PrescribedDisplacement::dof, "")
        .field("value", &LoadCase::PrescribedDisplacement::value, "m or rad")
        .done();
    Record<LoadCase::AreaLoad> area_load(load_case, "AreaLoad", "A load spread over an area.");
    Record<LoadCase::AreaLoad::Tiles>(area_load.type(), "Tiles", "Some tiles.")
        .field("numbers", &LoadCase::AreaLoad::Tiles::numbers, "")
        .done();
    area_load.field("where", &LoadCase::AreaLoad::where, "a selection, or LoadCase.AreaLoad.Tiles")
        .field("per_area", &LoadCase::AreaLoad::per_area, "3 floats, N/m2")
        .done();
    Record<LoadCase::Share>(load_case, "Share", "Another load case of the same project, with its factor.")
        .field("load_case", &LoadCase::Share::load_case, "its name")
        .field("factor", &LoadCase::Share::factor, "")
        .done();
}

void bind_load_case(py::module_& m) {
    bind_enum<LoadCase::Amount>(m);
    Record<LoadCase> outer(
        m, "LoadCase",
        "The supports and loads of a tessellation, all on interface nodes.\n\n>>> import fretwork as fw\n>>> "
        "case = fw.LoadCase(name='tip',\n...     supports=[fw.LoadCase.Support(fw.NodesAtSide('left'), "
        "'all')],\n...     loads=[fw.LoadCase.Load(fw.NodesAtSide('right'), force=[0, 0, -0.1])])\n>>> "
        "fw.parse_load_case(fw.load_case_text(case)) == case\nTrue\n");
    bind_entries(outer.type());
    outer.field("name", &LoadCase::name, "")
        .field("description", &LoadCase::description, "")
        .field("supports", &LoadCase::supports, "")
        .field("loads", &LoadCase::loads, "")
        .field("prescribed", &LoadCase::prescribed, "")
        .field("area_loads", &LoadCase::area_loads, "")
        .field("combines", &LoadCase::combines, "")
        .field("gravity", &LoadCase::gravity, "3 floats, m/s^2")
        .done();
    bind_files<LoadCase>(m, "load_case",
                         {&parse_load_case, &load_case_text, &read_load_case, &write_load_case});
    m.def(
        "combined",
        [](const LoadCase& load_case, const std::vector<LoadCase>& cases) {
            return combined(load_case, cases);
        },
        "load_case"_a, "cases"_a, "A load case together with the load cases that it combines.");
    m.def("entry_texts", &entry_texts, "load_case"_a, "tessellation"_a,
          "One line for each entry, for people.");
    m.def("check_selections", &check_selections, "load_case"_a, "tessellation"_a,
          "Check that every entry selects interface nodes. Raises InputError.");
}

void bind_stages(py::module_& m) {
    Record<LoadStage>(m, "LoadStage", "The changes in one load stage. Everything else stays unchanged.")
        .field("name", &LoadStage::name, "")
        .field("loads", &LoadStage::loads, "load cases, with the factor that their loads reach")
        .field("prescribed", &LoadStage::prescribed, "components that reach given values")
        .field("keep", &LoadStage::keep, "components that stay where they are")
        .field("free", &LoadStage::free, "components that are released, if they were prescribed or kept")
        .done();
    m.def("parse_stages", &parse_stages, "text"_a, "source"_a = "text",
          "Parse the text of a file of load stages.");
    m.def(
        "stages_text", [](const std::vector<LoadStage>& stages) { return stages_text(stages); }, "stages"_a);
    m.def("read_stages", &read_stages, "path"_a);
}

}  // namespace

void bind_load_cases(py::module_& m) {
    bind_selections(m);
    bind_load_case(m);
    bind_stages(m);
}

}  // namespace fretwork::python
