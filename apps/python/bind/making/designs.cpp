// SPDX-License-Identifier: GPL-3.0-or-later
// The search for a painting whose surface takes a wanted shape.
#include "core/bind.hpp"
#include "reduction/library_object.hpp"
#include "typed/palette_text.hpp"
#include "typed/symmetry_text.hpp"

#include <fretwork/base/error.hpp>
#include <fretwork/design/design.hpp>
#include <fretwork/design/target/target_file.hpp>

namespace pybind11::detail {

/// The symmetry of a painting: its text, None for none.
template <>
struct type_caster<fretwork::design::Symmetry> {
    PYBIND11_TYPE_CASTER(fretwork::design::Symmetry, const_name("Optional[str]"));
    bool load(handle source, bool) {
        if (source.is_none()) return true;
        if (!isinstance<str>(source)) return false;
        value = fretwork::typed::read_symmetry(source.cast<std::string>());
        return true;
    }
    static handle cast(const fretwork::design::Symmetry& symmetry, return_value_policy, handle) {
        if (symmetry.kind == fretwork::design::Symmetry::Kind::None) return none().release();
        return str(fretwork::design::symmetry_text(symmetry)).release();
    }
};

/// A warning of a design: its text, with lengths in millimetres and angles in degrees.
template <>
struct type_caster<fretwork::design::DesignWarning> {
    PYBIND11_TYPE_CASTER(fretwork::design::DesignWarning, const_name("str"));
    bool load(handle source, bool) {
        if (!isinstance<str>(source)) return false;
        value = {source.cast<std::string>()};
        return true;
    }
    static handle cast(const fretwork::design::DesignWarning& warning, return_value_policy, handle) {
        return str(fretwork::design::plain_text(warning)).release();
    }
};

/// Expressions of x and y: texts, or numbers; None where a component is free.
template <>
struct type_caster<std::array<std::optional<std::string>, 3>> {
    using Expressions = std::array<std::optional<std::string>, 3>;
    PYBIND11_TYPE_CASTER(Expressions, const_name("Tuple[Optional[str], Optional[str], Optional[str]]"));
    bool load(handle source, bool) {
        if (!isinstance<sequence>(source) || isinstance<str>(source) || len(source) != value.size())
            return false;
        const auto given = reinterpret_borrow<sequence>(source);
        for (std::size_t c = 0; c < value.size(); ++c) {
            const object one = given[c];
            const bool is_number = PyFloat_Check(one.ptr()) != 0 || PyLong_Check(one.ptr()) != 0;
            if (!one.is_none() && !is_number && !isinstance<str>(one)) return false;
            if (!one.is_none()) value[c] = str(one).cast<std::string>();
        }
        return true;
    }
    static handle cast(const Expressions& expressions, return_value_policy, handle) {
        return pybind11::make_tuple(expressions[0], expressions[1], expressions[2]).release();
    }
};

}  // namespace pybind11::detail

namespace fretwork::python {
namespace {

using namespace design;
using PaletteGiven = std::variant<std::string, std::vector<std::string>>;

void bind_goals(py::module_& m) {
    bind_enum<NodesGoal::Quantity>(m);
    Record<NodesGoal>(m, "NodesGoal", "Displacements or positions of single interface nodes.")
        .field("nodes", &NodesGoal::nodes, "n numbers")
        .field("values", &NodesGoal::values, "n rows of three, m; None: the component is free")
        .field("quantity", &NodesGoal::quantity, "")
        .done();
    Record<FormulaGoal>(m, "FormulaGoal", "Displacements of nodes by expressions of their places at rest.")
        .field("where", &FormulaGoal::where, "a selection")
        .field("displacement", &FormulaGoal::displacement,
               "three expressions of x and y (m), or numbers, m; None: the component is free")
        .done();
    Record<MeshGoal>(m, "MeshGoal", "Nodes lie on a surface in space, and may slide along the surface.")
        .field("where", &MeshGoal::where, "a selection")
        .field("mesh", &MeshGoal::mesh, "OBJ, PLY or OFF, m, in the axes of the project")
        .done();
    Record<RotationGoal>(m, "RotationGoal", "Nodes turn by a rotation vector.")
        .field("where", &RotationGoal::where, "a selection")
        .field("rotation", &RotationGoal::rotation, "three floats, rad; None: the component is free")
        .done();
}

void bind_target(py::module_& m) {
    Record<Goal>(m, "Goal", "A part of a target.")
        .field("what", &Goal::what, "a NodesGoal, FormulaGoal, MeshGoal or RotationGoal")
        .field("weight", &Goal::weight, "weight of the squared distance of each node")
        .field("load_case", &Goal::load_case, "load case of the goal; '': the load case of the design")
        .done();
    Record<Target>(m, "Target",
                   "The shape that a designed surface shall take, under one load case or several.\n\n"
                   ">>> import fretwork as fw\n"
                   ">>> lifted = fw.FormulaGoal(fw.NodesAtSide('right'), [None, None, 0.02])\n"
                   ">>> target = fw.Target('lifted', goals=[fw.Goal(lifted)])\n"
                   ">>> fw.parse_target(fw.target_text(target)) == target\n"
                   "True\n")
        .field("name", &Target::name, "")
        .field("description", &Target::description, "")
        .field("goals", &Target::goals, "")
        .done();
    bind_files<Target>(m, "target", {&parse_target, &target_text, &read_target, &write_target});
}

void bind_options(py::module_& m) {
    Record<DesignOptions>(m, "DesignOptions", "Options of design().")
        .field("load_case", &DesignOptions::load_case, "load case of goals that name none; '': the only one")
        .field("max_patterns", &DesignOptions::max_patterns,
               "largest number of different patterns; 0: any number")
        .field("keep", &DesignOptions::keep, "tiles that keep their patterns")
        .field("symmetry", &DesignOptions::symmetry, "'mirror:x', 'mirror:y', 'turn:N', or None")
        .field("max_mass", &DesignOptions::max_mass, "largest mass of all beams, kg; 0: any")
        .field("max_utilization", &DesignOptions::max_utilization,
               "largest stress, as a share of the setting's strength; 0: any")
        .field("free_factor", &DesignOptions::free_factor, "True: search the factor on the loads, too")
        .field("free_prescribed", &DesignOptions::free_prescribed,
               "True: search prescribed displacements, too")
        .field("free_width", &DesignOptions::free_width,
               "True: search the width of all bars (rectangles), too")
        .field("free_thickness", &DesignOptions::free_thickness,
               "True: search the thickness of all bars, too")
        .field("clearance", &DesignOptions::clearance, "smallest gap between bars, m; None: any")
        .field("seconds", &DesignOptions::seconds, "largest wall time, checks included, s; 0: any")
        .field("most_solutions", &DesignOptions::most_solutions,
               "largest number of nonlinear solutions of the search")
        .field("uniform_paintings", &DesignOptions::uniform_paintings,
               "number of single patterns with which the search begins")
        .field("shortlist", &DesignOptions::shortlist, "number of patterns from which one step chooses")
        .field("seed", &DesignOptions::seed, "")
        .field("threads", &DesignOptions::threads,
               "number of threads; 0: one for each processor; no bit of the result depends on the number")
        .done();
}

void bind_shapes(py::module_& m) {
    using GoalNode = CaseShape::GoalNode;
    Record<GoalNode>(m, "GoalNode", "A node of a goal.")
        .constant("node", &GoalNode::node, "its number")
        .constant("wanted", &GoalNode::wanted, "wanted place in space, m; free components keep their values")
        .constant("distance", &GoalNode::distance, "m")
        .done(Made::ByFunctions);
    Record<CaseShape>(m, "CaseShape", "The shape of a surface under one load case, with all beams.")
        .constant("load_case", &CaseShape::load_case, "its name")
        .constant("displacements", &CaseShape::displacements, "one row for each node, interface nodes first")
        .constant("goals", &CaseShape::goals, "GoalNodes")
        .done(Made::ByFunctions);
    Record<Curvatures>(m, "Curvatures", "The principal curvatures of a bent surface, 1/m.")
        .constant("largest", &Curvatures::largest, "")
        .constant("smallest", &Curvatures::smallest, "")
        .done(Made::ByFunctions);
    Record<Gamut>(m, "Gamut",
                  "Curvatures that the load gives to tiles, and curvatures that a target requires.")
        .constant("reached", &Gamut::reached,
                  "curvatures of all tiles with all single patterns that were tried")
        .constant("wanted", &Gamut::wanted, "wanted curvatures of tiles around which every node has a goal")
        .constant("designed", &Gamut::designed, "curvatures of the same tiles in the painting")
        .done(Made::ByFunctions)
        .def_property_readonly("share_outside", &Gamut::share_outside,
                               "share of the wanted curvatures that are far from all reached curvatures; "
                               "None if there are none");
}

void bind_report(py::module_& m) {
    bind_enum<DesignEnd>(m);
    Record<DesignProgress>(m, "DesignProgress", "The progress of a design: the best painting so far.")
        .constant("solutions", &DesignProgress::solutions, "number of nonlinear solutions so far")
        .constant("most", &DesignProgress::most, "largest number of nonlinear solutions of the search")
        .constant("seconds", &DesignProgress::seconds, "")
        .constant("misfit", &DesignProgress::misfit,
                  "misfit of the reduced model, as a share of the largest displacement wanted")
        .done(Made::ByFunctions);
    Record<TargetError>(m, "TargetError",
                        "Distances to the target, as shares of the largest displacement that it asks for, of "
                        "the full model, nonlinear, on the path from flat; if this path loses stability, on "
                        "the stable branch.")
        .constant("mean", &TargetError::mean, "")
        .constant("largest", &TargetError::largest, "")
        .constant("is_stable", &TargetError::is_stable, "")
        .constant("is_stable_from_flat", &TargetError::is_stable_from_flat,
                  "True if the path from flat ends at a stable equilibrium in all load cases")
        .done(Made::ByFunctions);
    bind_shapes(m);
    Record<DesignReport>(m, "DesignReport", "The painted project, and its distance from the target.")
        .constant("project", &DesignReport::project, "painted project; its load cases have the values found")
        .constant("error", &DesignReport::error, "None if the search was stopped before the check")
        .constant("best_uniform", &DesignReport::best_uniform,
                  "error of the best single pattern among those that were checked with all beams")
        .constant("best_uniform_pattern", &DesignReport::best_uniform_pattern, "its id")
        .constant("uniform_tried", &DesignReport::uniform_tried, "number of single patterns tried")
        .constant("uniform_solutions", &DesignReport::uniform_solutions,
                  "number of nonlinear solutions before the search leaves the single patterns")
        .constant("patterns", &DesignReport::patterns, "ids of the patterns in the painting")
        .constant("mass", &DesignReport::mass, "mass of all beams, kg")
        .constant("factors", &DesignReport::factors, "factor on the loads of each load case in load_cases")
        .constant("load_cases", &DesignReport::load_cases, "names of the load cases")
        .constant("largest_utilization", &DesignReport::largest_utilization,
                  "largest stress over the strength; None without a strength")
        .constant("utilization_error", &DesignReport::utilization_error,
                  "estimated error of largest_utilization, because each beam has one element; None unless "
                  "max_utilization is set")
        .constant("relaxed", &DesignReport::relaxed,
                  "predicted misfit of mixtures of patterns in each tile, or None")
        .constant(
            "wanted_of_softest", &DesignReport::wanted_of_softest,
            "largest displacement wanted, over the largest displacement of the softest single pattern under "
            "the given loads")
        .constant(
            "wanted_of_stiffest", &DesignReport::wanted_of_stiffest,
            "largest displacement wanted, over the largest displacement of the stiffest single pattern under "
            "the given loads")
        .constant("reach_of_ten_loads", &DesignReport::reach_of_ten_loads,
                  "displacement of the softest single pattern under ten times the loads, over the "
                  "displacement wanted; None: not computed")
        .constant("nothing_moves", &DesignReport::nothing_moves,
                  "True if the load cases move no uniform painting")
        .constant("width", &DesignReport::width, "width of the bars, m; None if it is not free")
        .constant("thickness", &DesignReport::thickness, "thickness of the bars, m; None if it is not free")
        .constant("bound", &DesignReport::bound,
                  "lower bound of the misfit of every painting, by linear theory; None if it does not apply")
        .constant("close_bars", &DesignReport::close_bars,
                  "number of pairs of bars nearer than the clearance")
        .constant("warnings", &DesignReport::warnings, "one line each")
        .constant("shapes", &DesignReport::shapes, "shapes of the painting, one for each load case")
        .constant("uniform_shapes", &DesignReport::uniform_shapes, "shapes of the best single pattern")
        .constant("gamut", &DesignReport::gamut, "curvatures")
        .constant("model_error", &DesignReport::model_error,
                  "mean distance between the reduced model and the full model, as a share of the largest "
                  "displacement wanted")
        .constant("start_misfits", &DesignReport::start_misfits,
                  "misfit that each start of the search reached")
        .constant("history", &DesignReport::history, "")
        .constant("end", &DesignReport::end, "")
        .constant("slides", &DesignReport::slides, "True if a goal lets nodes slide along a mesh")
        .constant("seconds", &DesignReport::seconds, "")
        .constant("solutions", &DesignReport::solutions, "number of nonlinear solutions of the search")
        .constant("full_solutions", &DesignReport::full_solutions,
                  "number of solutions with all beams, for the checks")
        .constant("seed", &DesignReport::seed, "")
        .done(Made::ByFunctions)
        .def_property_readonly("is_better", &DesignReport::is_better,
                               "True if the painting is better than the best single pattern");
}

std::vector<pattern::NamedPattern> palette_of(const PaletteGiven& given, const simulation::Project& project,
                                              const library::Library* library, std::uint64_t seed) {
    if (const auto* ids = std::get_if<std::vector<std::string>>(&given))
        return pattern::parse_named_patterns(project.layout, *ids);
    return typed::read_palette({std::get<std::string>(given), seed}, project.layout, library);
}

/// Wraps a Python listener. A KeyboardInterrupt in the listener ends the search as any other does.
std::function<void(const DesignProgress&)> listener(const py::object& given) {
    return [call = given.cast<std::function<void(const DesignProgress&)>>()](const DesignProgress& progress) {
        const py::gil_scoped_acquire acquired;
        try {
            call(progress);
        } catch (const py::error_already_set& error) {
            if (!error.matches(PyExc_KeyboardInterrupt)) throw;
            PyErr_SetInterrupt();
        }
    };
}

DesignReport run_design(const simulation::Project& project, const Target& target, const PaletteGiven& palette,
                        const LibraryPointer& library, const py::kwargs& named) {
    py::dict others(named.attr("copy")());
    const py::object on_better = taken(others, "on_better");
    Keywords<DesignOptions> keywords = Keywords<DesignOptions>::rest(others);
    DesignOptions& options = keywords.options;
    if (!on_better.is_none()) options.on_better = listener(on_better);
    if (options.load_case.empty() && project.load_cases.size() == 1)
        options.load_case = project.load_cases.front().name;
    return with_library(library, [&](const library::Library* opened) {
        options.palette = palette_of(palette, project, opened, options.seed);
        LongCall call(keywords.progress);
        return call.run_to_keep(
            [&](const base::Control& control) {
                options.control = control;
                return design::design(project, opened, target, options);
            },
            [](const DesignReport& report) { return report.end == DesignEnd::Stopped; });
    });
}

}  // namespace

void bind_designs(py::module_& m) {
    bind_goals(m);
    bind_target(m);
    bind_options(m);
    bind_report(m);
    m.def("design", &run_design, "project"_a, "target"_a, "palette"_a = "sample:64", "library"_a = py::none(),
          "Paint the tiles of a project so that its surface takes the target's shape. `palette` is a list of "
          "ids, or a word as on the command line: 'library', 'all', 'sample:N'. `on_better` is called with a "
          "DesignProgress. Ctrl-C ends the search and raises nothing once there is a painting: the report "
          "has the best one, and its `end` is 'stopped'.\n\nOptions: DesignOptions, on_better, progress\n");
}

}  // namespace fretwork::python
