// SPDX-License-Identifier: GPL-3.0-or-later
// Stresses of sessions: a smooth largest one with its gradient, and one whose place is computed in full.
#include "core/bind.hpp"
#include "surfaces/session_object.hpp"

#include <fretwork/simulation/derivatives/smooth_stress.hpp>
#include <fretwork/simulation/results/stress_refinement.hpp>

namespace fretwork::python {
namespace {

using namespace simulation;

void bind_smooth_stress(py::module_& m) {
    Record<SmoothStressOptions>(m, "SmoothStressOptions", "How smooth the stand-in for a largest stress is.")
        .field("exponent", &SmoothStressOptions::exponent,
               "p of the p-norm, at least 2: the larger, the nearer to the largest stress")
        .field("threads", &SmoothStressOptions::threads,
               "0: all there are; no bit of the result depends on it")
        .done();
    Record<SmoothStress>(m, "SmoothStress",
                         "A smooth stand-in for the largest von Mises stress over the beams of a surface.")
        .constant("value", &SmoothStress::value, "Pa: the p-norm over the points of all sections")
        .constant("largest", &SmoothStress::largest, "Pa: the largest stress itself, at most `value`")
        .constant("gradient", &SmoothStress::gradient,
                  "n x 6 floats: of value by displacements (Pa/m) and rotation vectors (Pa/rad)")
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
        "The p-norm of the von Mises stresses (Pa) in a result that the session gave since its last edit. "
        "Raises "
        "InputError for tile models other than condensed and corotational.\n\n"
        "Options: SmoothStressOptions\n");
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
        "How smooth_stress().value changes along a curve of settings, setting(t), at t = 0, while no node "
        "moves; "
        "derivative_along() has the rest. The values of the curve at -2, -1, 1 and 2 steps are asked for.\n\n"
        "Options: SmoothStressOptions\n");
}

void bind_refinement(py::module_& m) {
    m.def(
        "refine_stress",
        [](SessionObject& session, const std::vector<tiling::TileIndex>& full_tiles,
           const py::object& progress) {
            const auto use = session.use();
            return run_long(progress, [&](const base::Control& control) {
                RefinedStress refined = refine_stress(use->session, full_tiles, control);
                use->rows = refined.result.solution.displacements.rows();
                return refined;
            });
        },
        "session"_a, "full_tiles"_a = std::vector<tiling::TileIndex>{}, "progress"_a = py::none(),
        "The same of a session of reduced tiles, which keeps the tile models that it gets. `full_tiles` "
        "(numbers) are in full from the beginning.");
}

}  // namespace

void bind_surface_stresses(py::module_& m) {
    bind_smooth_stress(m);
    bind_refinement(m);
}

}  // namespace fretwork::python
