// SPDX-License-Identifier: GPL-3.0-or-later
// Stresses of sessions: a smooth largest stress with its gradient, and the largest with its tiles in full.
#include "core/bind.hpp"
#include "surfaces/session_object.hpp"

#include <fretwork/simulation/derivatives/smooth_stress.hpp>
#include <fretwork/simulation/results/stress_refinement.hpp>

namespace fretwork::python {
namespace {

using namespace simulation;

void bind_smooth_stress(py::module_& m) {
    Record<SmoothStressOptions>(m, "SmoothStressOptions", "Options of smooth_stress().")
        .field(
            "exponent", &SmoothStressOptions::exponent,
            "exponent p of the p-norm, at least 2; the larger p, the nearer the norm to the largest stress")
        .field("threads", &SmoothStressOptions::threads,
               "number of threads; 0: one for each processor; no bit of the result depends on the number")
        .done();
    Record<SmoothStress>(
        m, "SmoothStress",
        "A smooth approximation of the largest von Mises stress over the beams of a surface.")
        .constant("value", &SmoothStress::value, "p-norm over the points of all sections, Pa")
        .constant("largest", &SmoothStress::largest, "largest stress itself, Pa, at most `value`")
        .constant("gradient", &SmoothStress::gradient,
                  "n x 6 floats: derivatives of `value` with respect to displacements (Pa/m) and rotation "
                  "vectors (Pa/rad)")
        .done(Made::ByFunctions);
    m.def(
        "smooth_stress",
        [](SessionObject& session, const SurfaceResult& result, const py::kwargs& named) {
            const Keywords<SmoothStressOptions> keywords(named);
            const auto use = session.use();
            const py::gil_scoped_release released;
            return smooth_stress(use->session, checked(*use, result), keywords.options);
        },
        "session"_a, "result"_a,
        "The p-norm of the von Mises stresses (Pa) in a result from the session since its last edit. Raises "
        "InputError for tile models other than condensed and corotational.\n\nOptions: "
        "SmoothStressOptions\n");
    m.def(
        "smooth_stress_along",
        [](SessionObject& session, const SurfaceResult& result,
           const std::function<reduction::Setting(double)>& setting, double step, const py::kwargs& named) {
            const Keywords<SmoothStressOptions> keywords(named);
            const auto use = session.use();
            (void)checked(*use, result);
            const py::gil_scoped_release released;  // calls of `setting` take the lock for themselves
            return smooth_stress_along(use->session, result, {setting, step}, keywords.options);
        },
        "session"_a, "result"_a, "setting"_a, "step"_a,
        "The derivative of smooth_stress().value along a curve of settings, setting(t), at t = 0, while no "
        "node moves; derivative_along() gives the remaining part. setting() is called at -2, -1, 1 and 2 "
        "steps.\n\nOptions: SmoothStressOptions\n");
}

void bind_refinement(py::module_& m) {
    m.def(
        "refine_stress",
        [](SessionObject& session, const std::vector<tiling::TileIndex>& full_tiles,
           const py::object& progress) {
            const auto use = session.use();
            return run_long(progress, [&](const base::Control& control) {
                return refine_stress(use->session, full_tiles, control);
            });
        },
        "session"_a, "full_tiles"_a = std::vector<tiling::TileIndex>{}, "progress"_a = py::none(),
        "Refine the stress of a session of reduced tiles. The session keeps its new tile models. "
        "`full_tiles` (numbers) are in full from the start.");
}

}  // namespace

void bind_surface_stresses(py::module_& m) {
    bind_smooth_stress(m);
    bind_refinement(m);
}

}  // namespace fretwork::python
