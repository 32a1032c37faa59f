// SPDX-License-Identifier: GPL-3.0-or-later
// Equilibria of frames: results, modes, paths, and condensed matrices.
#include "core/bind.hpp"

#include <fretwork/base/error.hpp>
#include <fretwork/mechanics/condensation.hpp>
#include <fretwork/mechanics/linear_solver.hpp>
#include <fretwork/mechanics/modes.hpp>
#include <fretwork/mechanics/paths/linear_range.hpp>
#include <fretwork/mechanics/paths/path_tracing.hpp>
#include <fretwork/mechanics/results/section_forces.hpp>
#include <fretwork/mechanics/results/section_stress.hpp>
#include <fretwork/mechanics/solve.hpp>

namespace fretwork::python {
namespace {

using namespace mechanics;

void bind_solution_enums(py::module_& m) {
    bind_enum<Termination>(m);
    bind_enum<StabilityTest>(m);
    bind_enum<Solver>(m);
    bind_enum<Branch>(m);
    bind_enum<RotationalMass>(m);
}

void bind_solution(py::module_& m) {
    Record<StabilityLoss>(m, "StabilityLoss", "A loss of stability: the place where a path became unstable.")
        .constant("load_factor", &StabilityLoss::load_factor,
                  "critical load factor, at which the tangent is singular")
        .constant("node", &StabilityLoss::node, "node at which the critical mode is largest")
        .constant("dof", &StabilityLoss::dof, "component in which the critical mode is largest")
        .constant("pushed", &StabilityLoss::pushed, "True if the path continues on a stable branch")
        .done(Made::ByFunctions);
    Record<Solution>(m, "Solution", "One equilibrium of a structure.")
        .constant("load_factor", &Solution::load_factor, "factor on loads and prescribed displacements")
        .constant("termination", &Solution::termination, "")
        .constant("stable", &Solution::stable, "")
        .constant("stability", &Solution::stability, "test that decided the stability")
        .constant("displacements", &Solution::displacements,
                  "n x 6 floats, a read-only view: ux uy uz (m), rx ry rz (rotation vector, rad)")
        .constant("inner_displacements", &Solution::inner_displacements,
                  "rows of nodes inside divided beams and of hinges")
        .constant("reactions", &Solution::reactions, "n x 6 floats, a read-only view: N and N m")
        .constant("energy", &Solution::energy, "J, elastic")
        .constant("residual", &Solution::residual,
                  "norm of the unbalanced forces over the norm of loads and reactions")
        .constant("iterations", &Solution::iterations,
                  "number of linear solves since the last solution of the path")
        .constant("stability_losses", &Solution::stability_losses,
                  "losses of stability since the last solution of the path")
        .done(Made::ByFunctions)
        .def_property_readonly("converged", &Solution::converged);
    Record<Mode>(m, "Mode", "A mode of vibration or of buckling.")
        .constant("value", &Mode::value, "frequency in Hz for vibration, load factor for buckling")
        .constant("shape", &Mode::shape, "n x 6 floats; the largest displacement is 1")
        .constant("inner_shape", &Mode::inner_shape, "rows of the assembly's other nodes")
        .done(Made::ByFunctions);
    Record<DiscretizationError>(
        m, "DiscretizationError",
        "An estimate of the difference between a solution and the limit of ever finer divisions.")
        .constant("displacement", &DiscretizationError::displacement, "m")
        .constant("rotation", &DiscretizationError::rotation, "rad")
        .constant("share", &DiscretizationError::share,
                  "error as a share of the largest displacement or rotation")
        .constant("known", &DiscretizationError::known, "False if one of the two solutions does not exist")
        .done(Made::ByFunctions);
    Record<LinearRange>(
        m, "LinearRange",
        "An estimate of the distance between a linear solution and the solution for large displacements.")
        .constant("error", &LinearRange::error, "estimated error, as a share of the largest displacement")
        .constant("loses_stability", &LinearRange::loses_stability,
                  "True if the load exceeds the first load of buckling")
        .done(Made::ByFunctions);
}

/// The getter of rows of a result's solution, as a view of the result.
py::cpp_function rows_view(NodeValues Solution::*rows) {
    return py::cpp_function([rows](const Result& self) -> const NodeValues& { return self.solution.*rows; },
                            py::return_value_policy::reference_internal);
}

void bind_result(py::module_& m) {
    Record<Result> result(m, "Result",
                          "The solution of a structure, with further results that the options asked for.");
    Record<Result::Node>(result.type(), "Node", "A node of a result.")
        .constant("id", &Result::Node::id, "")
        .constant("rest_position", &Result::Node::rest_position, "3 floats, m")
        .constant("is_interface", &Result::Node::is_interface, "")
        .done(Made::ByFunctions);
    result.constant("solver", &Result::solver, "'linear', 'newton', ..")
        .constant("program", &Result::program,
                  "version of the program that wrote the file; empty: not read from a file")
        .constant("nodes", &Result::nodes, "")
        .constant("solution", &Result::solution, "")
        .constant("load_steps", &Result::load_steps,
                  "solutions of the load steps; empty unless the options ask for them")
        .constant("vibration_modes", &Result::vibration_modes, "empty unless the options ask for them")
        .constant("buckling_modes", &Result::buckling_modes, "empty unless the options ask for them")
        .constant("discretization_error", &Result::discretization_error, "None unless the options ask for it")
        .constant("seconds", &Result::seconds, "")
        .done(Made::ByFunctions)
        .def_property_readonly(
            "displacements", rows_view(&Solution::displacements),
            "n x 6 floats, a read-only view: ux uy uz (m), rx ry rz (rotation vector, rad)")
        .def_property_readonly("reactions", rows_view(&Solution::reactions),
                               "n x 6 floats, a read-only view: N and N m")
        .def_property_readonly("converged", [](const Result& self) { return self.solution.converged(); })
        .def_property_readonly("stable", [](const Result& self) { return self.solution.stable; })
        .def_property_readonly(
            "energy", [](const Result& self) { return self.solution.energy; }, "J, elastic")
        .def_property_readonly(
            "rest_positions",
            [](const Result& self) {
                std::vector<Eigen::Vector3d> places;
                for (const Result::Node& node : self.nodes) places.push_back(node.rest_position);
                return places;
            },
            "n x 3 floats, m");
    bind_files<Result>(m, "result", {&parse_result, &result_text, &read_result, &write_result});
}

void bind_solve(py::module_& m) {
    Record<SolveOptions>(m, "SolveOptions", "Options of solve().")
        .field("solver", &SolveOptions::solver, "")
        .field("steps", &SolveOptions::steps,
               "Newton: number of equal load steps, each of whose solutions is kept")
        .field("branch", &SolveOptions::branch, "Newton: equilibria to follow; None: primary")
        .field("rotational_mass", &SolveOptions::rotational_mass,
               "dynamic relaxation: fictitious masses; None: natural")
        .field("threads", &SolveOptions::threads,
               "linear and Newton: number of threads; None or 0: one for each processor")
        .field("locate_critical_loads", &SolveOptions::locate_critical_loads, "Newton")
        .field("estimate_error", &SolveOptions::estimate_error,
               "Newton: estimate the error of the beams' divisions")
        .field("lumped_gravity", &SolveOptions::lumped_gravity, "put half of a beam's weight on each end")
        .field("vibration_modes", &SolveOptions::vibration_modes, "number of natural frequencies at rest")
        .field("buckling_modes", &SolveOptions::buckling_modes, "number of critical load factors")
        .done();
    m.def(
        "solve",
        [](const LabelledFrame& frame, const py::kwargs& named) {
            return Keywords<SolveOptions>(named).run(
                [&](const auto& options) { return solve(frame, options); });
        },
        "frame"_a, "Solve a labelled frame.\n\nOptions: SolveOptions, progress\n");
    m.def(
        "solve",
        [](const Frame& frame, const py::kwargs& named) {
            Keywords<SolveOptions> keywords(named);
            LabelledFrame labelled{frame, {}};
            for (std::size_t n = 0; n < frame.nodes.size(); ++n)
                labelled.labels.push_back(static_cast<int>(n));
            return keywords.run([&](const auto& options) { return solve(labelled, options); });
        },
        "frame"_a,
        "Solve a frame. A solution that has not converged is an outcome: see Result.converged. Raises "
        "InputError, NumericalError that names a node if the frame can move freely.\n\nOptions: "
        "SolveOptions, progress\n");
    m.def("solver_names", [] { return solver_names(); });
    m.def("branch_names", [] { return branch_names(); });
}

void bind_paths(py::module_& m) {
    Record<EquilibriumOptions>(m, "EquilibriumOptions", "Options of the geometrically nonlinear solve.")
        .field("relative_residual", &EquilibriumOptions::relative_residual,
               "residual below which a solution has converged")
        .field("largest_rotation_step", &EquilibriumOptions::largest_rotation_step,
               "largest rotation of a node in a Newton step, rad")
        .field("iterations_per_step", &EquilibriumOptions::iterations_per_step, "")
        .field("classify_stability", &EquilibriumOptions::classify_stability, "")
        .field("branch", &EquilibriumOptions::branch, "")
        .field("locate_critical_loads", &EquilibriumOptions::locate_critical_loads, "")
        .field("threads", &EquilibriumOptions::threads, "number of threads; 0: one for each processor")
        .done();
    m.def(
        "follow_load_path",
        [](const Frame& frame, const std::vector<double>& load_factors, const py::kwargs& named) {
            return Keywords<EquilibriumOptions>(named).run([&](const auto& options) {
                return follow_load_path(assemble(frame, {.control = options.control}), load_factors, options);
            });
        },
        "frame"_a, "load_factors"_a,
        "Follow the load path from rest through load factors (ascending, > 0; 1: the full load). Returns a "
        "list with one Solution for each.\n\nOptions: EquilibriumOptions, progress\n");
    Record<PathTracingOptions>(m, "PathTracingOptions", "Options of tracing a path by arc length.")
        .field("first_load_step", &PathTracingOptions::first_load_step, "share of the load in the first step")
        .field("largest_load_factor", &PathTracingOptions::largest_load_factor,
               "load factor beyond which the path ends")
        .field("largest_arc", &PathTracingOptions::largest_arc,
               "largest arc length of one step, in rad and element lengths")
        .field("steps", &PathTracingOptions::steps, "number of steps after which the path ends")
        .field("largest_cut_back", &PathTracingOptions::largest_cut_back,
               "largest number of times that a step is halved")
        .done();
    m.def(
        "trace_path",
        [](const Frame& frame, const py::kwargs& named) {
            py::dict rest(named.attr("copy")());
            const py::object progress = taken(rest, "progress");
            auto keywords = Keywords<PathTracingOptions>::rest(rest);
            return run_long(progress, [&](const base::Control& control) {
                keywords.options.equilibrium.control = control;
                return trace_path(assemble(frame, {.control = control}), keywords.options);
            });
        },
        "frame"_a,
        "Follow the path from rest by its arc length, through limit points, at which the load turns "
        "back.\n\nOptions: PathTracingOptions, progress\n");
}

Eigen::MatrixXd condensed(const Frame& frame, int kept,
                          Eigen::MatrixXd (*condense_to)(const Assembly&, std::span<const NodeIndex>)) {
    if (kept < 0 || kept > std::ssize(frame.nodes))
        throw base::InputError("the frame has " + std::to_string(frame.nodes.size()) + " nodes, and " +
                               std::to_string(kept) + " of them are to be kept");
    return condense_to(assemble(frame), first_nodes(kept));
}

void bind_condensation(py::module_& m) {
    m.def(
        "condense", [](const Frame& frame, int kept) { return condensed(frame, kept, &condense); }, "frame"_a,
        "kept"_a,
        "Condense the linear stiffness onto the first `kept` nodes. Returns 6n x 6n floats: symmetric, SI; "
        "rows in the order ux uy uz rx ry rz of each node.");
    m.def(
        "condense_mass", [](const Frame& frame, int kept) { return condensed(frame, kept, &condense_mass); },
        "frame"_a, "kept"_a, "The consistent mass, condensed onto the first `kept` nodes: 6n x 6n floats.");
    m.def(
        "following", [](const Frame& frame, int kept) { return condensed(frame, kept, &following); },
        "frame"_a, "kept"_a,
        "The matrix by which the other nodes follow the first `kept` nodes: 6(m - n) x 6n floats.");
    m.def(
        "vibration_modes",
        [](const Frame& frame, int count, const py::object& progress) {
            return run_long(progress, [&](const base::Control& control) {
                return vibration_modes(assemble(frame), count, {.control = control});
            });
        },
        "frame"_a, "count"_a, "progress"_a = py::none(), "The modes of the lowest natural frequencies.");
    m.def(
        "buckling_modes",
        [](const Frame& frame, int count, const py::object& progress) {
            return run_long(progress, [&](const base::Control& control) {
                return buckling_modes(assemble(frame), count, {.control = control});
            });
        },
        "frame"_a, "count"_a, "progress"_a = py::none(),
        "The modes of linearized buckling; there may be fewer than `count`.");
    m.def(
        "linear_range",
        [](const Frame& frame, int threads, const py::object& progress) {
            return run_long(progress, [&](const base::Control& control) {
                return linear_range(assemble(frame), {.threads = threads, .control = control});
            });
        },
        "frame"_a, "threads"_a = 1, "progress"_a = py::none(),
        "An estimate of the distance between the frame's linear solution and the solution for large "
        "displacements.");
}

void bind_stresses(py::module_& m) {
    Record<SectionForces>(m, "SectionForces", "Forces and moments at a cut, along the beam's local axes.")
        .field("N", &SectionForces::N, "N, axial")
        .field("V2", &SectionForces::V2, "shear force along axis 2, N")
        .field("V3", &SectionForces::V3, "shear force along axis 3, N")
        .field("T", &SectionForces::T, "N m, torsion")
        .field("M2", &SectionForces::M2, "bending moment about axis 2, N m")
        .field("M3", &SectionForces::M3, "bending moment about axis 3, N m")
        .done();
    Record<SectionStress>(m, "SectionStress", "The largest absolute stresses over a section, Pa.")
        .field("normal", &SectionStress::normal, "Pa")
        .field("shear", &SectionStress::shear, "Pa")
        .field("von_mises", &SectionStress::von_mises, "Pa")
        .done();
    m.def(
        "largest_stress",
        [](const Section& section, const SectionForces& forces) {
            return SectionPoints(section).largest(forces);
        },
        "section"_a, "forces"_a, "The largest absolute stresses over a section under section forces.");
}

}  // namespace

void bind_solvers(py::module_& m) {
    bind_solution_enums(m);
    bind_solution(m);
    bind_result(m);
    bind_solve(m);
    bind_paths(m);
    bind_condensation(m);
    bind_stresses(m);
}

}  // namespace fretwork::python
