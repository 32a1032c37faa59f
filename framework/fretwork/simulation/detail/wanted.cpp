// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/simulation/detail/wanted.hpp>
#include <fretwork/simulation/results/surface_beams.hpp>
#include <fretwork/simulation/results/surface_linear_range.hpp>
#include <fretwork/simulation/results/surface_modes.hpp>

#include <utility>

namespace fretwork::simulation::detail {
namespace {

/// The number of a result's first nodes that are nodes of the full model: all, or the interface nodes.
Eigen::Index common_nodes(const SurfaceResult& result, const SurfaceBeams& full) {
    return has_nodes_at(result, full.nodes) ? std::ssize(result.nodes)
                                            : static_cast<Eigen::Index>(full.interface_nodes);
}

}  // namespace

void add_wanted(const Surface& surface, const LoadCase& load_case, const SimulationOptions& options,
                const base::Control& control, SurfaceResult& result) {
    const auto modes = [&](ModeKind kind, int count) {
        if (count == 0) return std::vector<mechanics::Mode>{};
        auto found = surface_modes(surface, load_case, kind, count, {.control = control});
        // Modes are those of the full model. Inner nodes of another model rest in the drawing.
        const Eigen::Index common = common_nodes(result, surface_beams(surface));
        for (mechanics::Mode& mode : found) {
            mechanics::NodeValues rows =
                mechanics::NodeValues::Zero(std::ssize(result.nodes), mechanics::kDofsPerNode);
            rows.topRows(common) = mode.shape.topRows(common);
            mode.shape = std::move(rows);
        }
        return found;
    };
    result.vibration_modes = modes(ModeKind::Vibration, options.vibration_modes);
    result.buckling_modes = modes(ModeKind::Buckling, options.buckling_modes);
    const bool is_linear = !is_nonlinear(surface, options);
    if (options.estimate_linear_range && is_linear && result.solution.converged())
        add_linear_range(surface, load_case, options, control, result);
}

}  // namespace fretwork::simulation::detail
