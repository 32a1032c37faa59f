// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/simulation/detail/wanted.hpp>
#include <fretwork/simulation/results/surface_beams.hpp>
#include <fretwork/simulation/results/surface_linear_range.hpp>
#include <fretwork/simulation/results/surface_modes.hpp>

#include <algorithm>

namespace fretwork::simulation::detail {
namespace {

/// True if the nodes of a result are the nodes of the full model. Equal numbers do not suffice: a model with
/// nodes of its own in each tile may have as many of them as the patterns.
bool has_nodes_of(const SurfaceResult& result, const SurfaceBeams& full) {
    constexpr double kSamePlace = 1e-9;  // m
    return std::ranges::equal(result.nodes, full.nodes, [](const auto& node, const Eigen::Vector3d& place) {
        return (node.rest_position - place).norm() <= kSamePlace;
    });
}

/// The shape of a mode of the full model, with a row for each node of the result. If the result is of another
/// model, it has other inner nodes, and their rows are zero.
mechanics::NodeValues shape_of_result(const mechanics::NodeValues& shape, const SurfaceBeams& full,
                                      const SurfaceResult& result) {
    const auto all = std::ssize(result.nodes);
    const auto own = has_nodes_of(result, full) ? all : static_cast<Eigen::Index>(full.interface_nodes);
    mechanics::NodeValues rows = mechanics::NodeValues::Zero(all, mechanics::kDofsPerNode);
    rows.topRows(own) = shape.topRows(own);
    return rows;
}

}  // namespace

void add_wanted(const Surface& surface, const LoadCase& load_case, const SimulationOptions& options,
                const base::Control& control, SurfaceResult& result) {
    const auto modes = [&](ModeKind kind, int count) {
        if (count == 0) return std::vector<mechanics::Mode>{};
        auto found = surface_modes(surface, load_case, kind, count, {.control = control});
        const SurfaceBeams full = surface_beams(surface);
        for (mechanics::Mode& mode : found) mode.shape = shape_of_result(mode.shape, full, result);
        return found;
    };
    result.vibration_modes = modes(ModeKind::Vibration, options.vibration_modes);
    result.buckling_modes = modes(ModeKind::Buckling, options.buckling_modes);
    const bool is_linear = !is_nonlinear(surface, options);
    if (options.estimate_linear_range && is_linear && result.solution.converged())
        add_linear_range(surface, load_case, options, control, result);
}

}  // namespace fretwork::simulation::detail
