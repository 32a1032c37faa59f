// SPDX-License-Identifier: GPL-3.0-or-later
// Results of surfaces, their comparison, and the forces in their beams.
#include "core/bind.hpp"
#include "reduction/tile_builds.hpp"

#include <fretwork/base/error.hpp>
#include <fretwork/simulation/results/bar_clearance.hpp>
#include <fretwork/simulation/results/beam_table.hpp>
#include <fretwork/simulation/results/comparison.hpp>
#include <fretwork/simulation/results/model_doubt.hpp>
#include <fretwork/simulation/results/stress_refinement.hpp>
#include <fretwork/simulation/results/surface_beams.hpp>
#include <fretwork/simulation/results/surface_linear_range.hpp>
#include <fretwork/simulation/results/surface_modes.hpp>
#include <fretwork/simulation/results/surface_result.hpp>
#include <fretwork/simulation/surface_frame.hpp>

namespace fretwork::python {
namespace {

using namespace simulation;
using Models = std::optional<std::vector<reduction::TileModel>>;

void bind_subject(py::module_& m) {
    Record<ResultSubject>(m, "ResultSubject", "The surface, load case and model that a result belongs to.")
        .constant("model", &ResultSubject::model, "the tile model")
        .constant("is_reference", &ResultSubject::is_reference, "True if every tile has all of its beams")
        .constant("load_case", &ResultSubject::load_case, "its name")
        .constant("load_case_text", &ResultSubject::load_case_text, "text of the load case file")
        .constant("tessellation_hash", &ResultSubject::tessellation_hash, "SHA-256")
        .constant("painting_hash", &ResultSubject::painting_hash, "SHA-256")
        .constant("setting_hash", &ResultSubject::setting_hash, "SHA-256")
        .constant("joints", &ResultSubject::joints, "joints of the setting; None in older files")
        .constant("full_tiles", &ResultSubject::full_tiles, "tiles with all of their beams, in a mixed model")
        .constant("stages_text", &ResultSubject::stages_text, "load stages that were followed")
        .constant("stage_load_cases", &ResultSubject::stage_load_cases,
                  "load case files that the load stages name")
        .done(Made::ByFunctions);
    Record<ModelError>(m, "ModelError",
                       "The estimated distance of a surface's solution from the full model's solution.")
        .constant("mean", &ModelError::mean, "mean error, as a share of the largest displacement")
        .constant("largest", &ModelError::largest, "largest error, as a share of the largest displacement")
        .constant("relative_l2", &ModelError::relative_l2,
                  "estimated |full - reduced| / |full| over all translations")
        .constant("largest_stress", &ModelError::largest_stress,
                  "error of the largest stress, a share, or None")
        .constant("full_share", &ModelError::full_share,
                  "share of the tiles that the estimate computes in full")
        .done(Made::ByFunctions);
    Record<ModelDoubt>(m, "ModelDoubt",
                       "The quantities that show whether a solution of corotational tiles may be far from "
                       "the full model's solution.")
        .constant("tile_rotation", &ModelDoubt::tile_rotation,
                  "largest rotation of a node relative to the corotating axes of its tile, rad")
        .constant("change", &ModelDoubt::change,
                  "for mixed models, change of the solution by tiles in full, as a share of the largest "
                  "displacement")
        .done(Made::ByFunctions);
}

void bind_surface_result(py::module_& m) {
    const auto base = py::reinterpret_borrow<py::class_<mechanics::Result>>(m.attr("Result"));
    Record<SurfaceResult>(m, "SurfaceResult", base,
                          "The solution of a surface. Rows of interface nodes come first; arrays are views "
                          "that keep their result alive.")
        .constant("subject", &SurfaceResult::subject, "surface, load case and model of the result, or None")
        .constant("linear_range", &SurfaceResult::linear_range,
                  "error estimate of linear solutions; None unless the options ask for it")
        .constant("fit_error", &SurfaceResult::fit_error,
                  "error of the fit, for linear solutions of fitted tiles, a share, or None")
        .constant("model_doubt", &SurfaceResult::model_doubt,
                  "doubt about nonlinear results of reduced tiles, or None")
        .constant("model_error", &SurfaceResult::model_error,
                  "error estimate of reduced models; None unless the options ask for it")
        .constant("buckled_tiles", &SurfaceResult::buckled_tiles,
                  "tiles that buckle; None unless the options ask for the model error")
        .done(Made::ByFunctions)
        .def_property_readonly(
            "largest_displacement",
            [](const SurfaceResult& self) { return largest_displacement(self, self.solution); },
            "The largest displacement of an interface node, m.")
        .def_property_readonly(
            "largest_rotation",
            [](const SurfaceResult& self) { return largest_rotation(self, self.solution); },
            "The largest rotation of an interface node, rad.");
    m.def("is_doubtful", &is_doubtful, "result"_a,
          "True if the error of the result may be large and should be estimated.");
    m.def(
        "path_warning", &path_warning, "result"_a,
        "A warning about a result that is not the answer to its load, or is unstable; '' if there is none.");
    m.def("model_warning", &model_warning, "result"_a,
          "A warning about a result whose error is or may be large; '' if there is none.");
    m.def("result_warnings", &result_warnings, "result"_a,
          "All warnings about a result: its path, the range of a linear solution, its model.");
    bind_files<SurfaceResult>(
        m, "surface_result",
        {&parse_surface_result, &surface_result_text, &read_surface_result, &write_surface_result});
}

void bind_comparison(py::module_& m) {
    Record<Comparison>(
        m, "Comparison",
        "The distance of a reduced model's interface nodes from the full model's: a row of Table 3.")
        .constant("width", &Comparison::width, "m")
        .constant("height", &Comparison::height, "m")
        .constant("max_displacement", &Comparison::max_displacement, "m")
        .constant("max_translation_error", &Comparison::max_translation_error, "m")
        .constant("mean_translation_error", &Comparison::mean_translation_error, "m")
        .constant("sd_translation_error", &Comparison::sd_translation_error, "m")
        .constant("max_rotation", &Comparison::max_rotation, "rad")
        .constant("max_rotation_error", &Comparison::max_rotation_error, "rad")
        .constant("mean_rotation_error", &Comparison::mean_rotation_error, "rad")
        .constant("sd_rotation_error", &Comparison::sd_rotation_error, "rad")
        .constant("relative_l2_error", &Comparison::relative_l2_error,
                  "|full - reduced| / |full| over all translations")
        .constant("full_seconds", &Comparison::full_seconds, "")
        .constant("reduced_seconds", &Comparison::reduced_seconds, "")
        .constant("full_is_unstable", &Comparison::full_is_unstable, "")
        .constant("joints", &Comparison::joints, "joints of the setting; None if no file names them")
        .done(Made::ByFunctions);
    m.def("compare", &compare, "full"_a, "reduced"_a,
          "Compare two results of one surface. Raises InputError if they do not belong together.");
    m.def("comparison_text", &comparison_text, "comparison"_a, "The comparison in a few lines for people.");
    m.def("comparison_header", &comparison_header, "The header of the table.");
    m.def("comparison_row", &comparison_row, "example"_a, "comparison"_a, "A row of the table.");
}

void bind_beams(py::module_& m) {
    Record<BeamRow>(m, "BeamRow", "Forces and stress of one beam of a surface.")
        .constant("beam", &BeamRow::beam, "its number")
        .constant("tile", &BeamRow::tile, "")
        .constant("nodes", &BeamRow::nodes, "numbers of the ends in the full model")
        .constant("forces", &BeamRow::forces, "SectionForces at both ends")
        .constant("stress", &BeamRow::stress, "largest normal stress at each end, Pa")
        .constant("von_mises", &BeamRow::von_mises, "largest von Mises stress at each end, Pa")
        .done(Made::ByFunctions)
        .def_property_readonly("largest_stress", &BeamRow::largest_stress, "Pa")
        .def_property_readonly("largest_von_mises", &BeamRow::largest_von_mises, "Pa");
    Record<BeamTable>(m, "BeamTable", "The beams of a surface in a result.")
        .constant("rows", &BeamTable::rows, "beams whose tile model knows their motion")
        .constant("unknown", &BeamTable::unknown, "number of beams of other tiles")
        .constant("strength", &BeamTable::strength,
                  "strength of the material, Pa, the reference of utilizations")
        .constant("joints", &BeamTable::joints, "joints of the setting")
        .constant("is_shape_given", &BeamTable::is_shape_given, "")
        .done(Made::ByFunctions)
        .def("utilization", &BeamTable::utilization, "row"_a,
             "The utilization of a beam; None without a strength.");
    m.def(
        "beam_table",
        [](const Surface& surface, const SurfaceResult& result, const Models& models) {
            const auto own = models_or_all(models);
            const py::gil_scoped_release released;  // tiles are built by several threads
            return beam_table(surface, result, own);
        },
        "surface"_a, "result"_a, "models"_a = py::none(), "Section forces and stresses of all beams.");
    m.def("most_stressed", &most_stressed, "table"_a, "count"_a,
          "The rows, sorted by von Mises stress, the largest first.");
    m.def("beam_table_csv", &beam_table_csv, "table"_a, "surface"_a, "The table as CSV, SI.");
}

void bind_surface_beams(py::module_& m) {
    Record<SurfaceBeams>(m, "SurfaceBeams", "The beams of a surface in the plane, at rest.")
        .constant("interface_nodes", &SurfaceBeams::interface_nodes,
                  "number of interface nodes, which are the first nodes")
        .constant("nodes", &SurfaceBeams::nodes, "n x 3 floats, m: rest positions")
        .constant("ends", &SurfaceBeams::ends, "pairs of nodes")
        .constant("tiles", &SurfaceBeams::tiles, "tile of each beam")
        .constant("joint_reaches", &SurfaceBeams::joint_reaches, "joint reach of each beam")
        .done(Made::ByFunctions);
    Record<BeamState>(m, "BeamState", "The displacements and stresses of the beams of a surface.")
        .constant("nodes", &BeamState::nodes, "n x 6 floats; NaN where a tile model does not know the motion")
        .constant("forces", &BeamState::forces,
                  "2b x 8 floats, two rows for each beam: N V2 V3 T M2 M3, stress and von Mises stress (Pa)")
        .done(Made::ByFunctions);
    m.def("surface_beams", &surface_beams, "surface"_a);
    m.def(
        "beam_state",
        [](const Surface& surface, const SurfaceResult& result, const Models& models) {
            const auto own = models_or_all(models);
            const py::gil_scoped_release released;
            const SurfaceBeams beams = surface_beams(surface);
            return beam_state(surface, result, beams, beam_sections(beams, surface.setting), own);
        },
        "surface"_a, "result"_a, "models"_a = py::none(),
        "The state of the beams of surface_beams() in a result.");
}

void bind_checks(py::module_& m) {
    Record<CloseBars>(m, "CloseBars", "Two bars that are too near to each other.")
        .constant("bars", &CloseBars::bars, "")
        .constant("tiles", &CloseBars::tiles, "tiles of the bars")
        .constant("gap", &CloseBars::gap,
                  "distance between the rims of the bars, m; below zero if they overlap")
        .done(Made::ByFunctions);
    m.def(
        "close_bars",
        [](const Surface& surface, double clearance, const py::object& progress) {
            return run_long(progress, [&](const base::Control& control) {
                return close_bars(surface, clearance, control);
            });
        },
        "surface"_a, "clearance"_a, "progress"_a = py::none(),
        "The pairs of bars whose rims are nearer than a clearance (m).");
    Record<RefinedStress>(m, "RefinedStress",
                          "A solution whose largest stress lies in tiles with all of their beams.")
        .constant("result", &RefinedStress::result, "")
        .constant("table", &RefinedStress::table, "forces and stresses of the beams")
        .constant("full_tiles", &RefinedStress::full_tiles, "tiles with all of their beams, ascending")
        .constant("solutions", &RefinedStress::solutions, "number of nonlinear solutions")
        .constant("is_settled", &RefinedStress::is_settled,
                  "True if the tiles around the most stressed beam are in full; False if an equilibrium was "
                  "not found")
        .done(Made::ByFunctions);
    bind_enum<ModeKind>(m);
    m.def(
        "surface_modes",
        [](const Surface& surface, const LoadCase& load_case, ModeKind kind, int count,
           const py::object& progress) {
            return run_long(progress, [&](const base::Control& control) {
                return surface_modes(surface, load_case, kind, count, {.control = control});
            });
        },
        "surface"_a, "load_case"_a, "kind"_a, "count"_a, "progress"_a = py::none(),
        "The lowest modes of a surface with all of its beams.");
    m.def(
        "refine_stress",
        [](const Surface& surface, const SurfaceResult& result, const py::object& progress) {
            return run_long(progress, [&](const base::Control& control) {
                return refine_stress(surface, result, control);
            });
        },
        "surface"_a, "result"_a, "progress"_a = py::none(),
        "From a nonlinear result of corotational or mixed tiles, put the tiles around the most stressed beam "
        "in full until all of them are.");
    m.def(
        "surface_linear_range",
        [](const Surface& surface, const LoadCase& load_case, int threads, const py::object& progress) {
            return run_long(progress, [&](const base::Control& control) {
                return surface_linear_range(surface, load_case, threads, control);
            });
        },
        "surface"_a, "load_case"_a, "threads"_a = 0, "progress"_a = py::none(),
        "An estimate of the distance between a linear solution of the surface and the solution for large "
        "displacements.");
    m.def(
        "surface_frame",
        [](const Surface& surface, const LoadCase& load_case, const std::string& model,
           const Models& models) {
            const auto rows = models_or_all(models);
            const py::gil_scoped_release released;  // tiles are built by several threads
            return surface_frame(surface, {model, rows}, resolve(load_case, surface));
        },
        "surface"_a, "load_case"_a, "model"_a = "full", "models"_a = py::none(),
        "The surface under a load case as a frame, which any other solver can solve for comparison.");
}

}  // namespace

void bind_results(py::module_& m) {
    bind_subject(m);
    bind_surface_result(m);
    bind_comparison(m);
    bind_beams(m);
    bind_surface_beams(m);
    bind_checks(m);
}

}  // namespace fretwork::python
