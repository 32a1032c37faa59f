// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/stopwatch.hpp>
#include <fretwork/mechanics/discretization.hpp>
#include <fretwork/mechanics/paths/equilibrium.hpp>
#include <fretwork/mechanics/solve.hpp>
#include <fretwork/simulation/detail/session_impl.hpp>
#include <fretwork/simulation/detail/tile_deformations.hpp>
#include <fretwork/simulation/surface_frame.hpp>

#include <algorithm>

namespace fretwork::simulation {
namespace {

using tiling::TileIndex;

}  // namespace

void Session::Impl::build_all(const base::Control& control) {
    join(builder_.build_all(surface_, choice(), {options_.threads, control}), control);
}

/// Changes nothing if it throws.
void Session::Impl::join(std::vector<detail::BuiltTile> tiles, const base::Control& control) {
    detail::JoinedTiles joined = detail::join_tiles(surface_, tiles, control);
    assembly_ = reduction::assemble(joined.parts, control);
    tile_supports_ = assembly_.supports.size();
    starts_ = std::move(joined.starts);
    tiles_ = std::move(tiles);
    changed_tiles_.clear();
}

/// False if a tile has or had inner nodes or beams, or has a new number of elements: the caller then joins.
bool Session::Impl::replace_elements(std::span<const TileIndex> tiles,
                                     std::span<const detail::BuiltTile> built) {
    std::vector<mechanics::Elements> replacements;
    for (std::size_t i = 0; i < tiles.size(); ++i) {
        auto elements = detail::replacement(starts_, surface_, tiles[i], built[i]);
        if (!elements) return false;
        replacements.push_back(std::move(*elements));
    }
    for (std::size_t i = 0; i < tiles.size(); ++i) {
        const auto first = static_cast<std::ptrdiff_t>(detail::first_element(assembly_, starts_, tiles[i]));
        std::ranges::copy(replacements[i], assembly_.elements.begin() + first);
    }
    return true;
}

void Session::Impl::update_tiles(const base::Control& control) {
    if (tiles_.empty()) return build_all(control);
    if (changed_tiles_.empty()) return;
    const std::vector<TileIndex> tiles(changed_tiles_.begin(), changed_tiles_.end());
    std::vector<detail::BuiltTile> built =
        builder_.build({surface_, choice(), tiles}, {options_.threads, control});
    const auto put_into = [&](std::vector<detail::BuiltTile>& all) {
        for (std::size_t i = 0; i < tiles.size(); ++i) all[tiles[i]] = std::move(built[i]);
    };
    if (replace_elements(tiles, built)) {
        put_into(tiles_);
        changed_tiles_.clear();
    } else {
        std::vector<detail::BuiltTile> all = tiles_;
        put_into(all);
        join(std::move(all), control);
    }
}

void Session::Impl::update_conditions() {
    assembly_.supports.resize(tile_supports_);
    apply(conditions_, assembly_);
}

/// Compute everything that edits have put out of date, except factors.
void Session::Impl::update(const base::Control& control) {
    const std::size_t built_before = builder_.built_count();
    update_tiles(control);
    update_conditions();
    report_ = {.tiles_built = builder_.built_count() - built_before};
}

const mechanics::LinearSolver& Session::Impl::updated_solver(const base::Control& control) {
    if (!solver_) {
        report_.factors = Report::Factors::Refactorized;
        return solver_.emplace(assembly_,
                               mechanics::LinearOptions{.threads = options_.threads, .control = control});
    }
    report_.factors = solver_->update(assembly_, control);
    return *solver_;
}

bool Session::Impl::is_nonlinear() const {
    return simulation::is_nonlinear(surface_, options_);
}

SurfaceResult Session::Impl::make_result() const {
    SurfaceResult result;
    result.nodes = detail::result_nodes(surface_, assembly_);
    return result;
}

void Session::Impl::solve_path(SurfaceResult& result, const base::Control& control) const {
    mechanics::Result path = mechanics::solve(assembly_, {.solver = mechanics::Solver::Newton,
                                                          .steps = options_.load_steps,
                                                          .branch = options_.branch,
                                                          .threads = options_.threads,
                                                          .locate_critical_loads = false,
                                                          .control = control});
    result.load_steps = std::move(path.load_steps);
    result.solution = std::move(path.solution);
}

void Session::Impl::solve_equilibrium(SurfaceResult& result, const base::Control& control,
                                      mechanics::StabilityCheck check,
                                      const mechanics::FirstIterate& first_iterate) {
    if (!equilibrium_solver_)
        equilibrium_solver_.emplace(
            mechanics::EquilibriumOptions{.branch = options_.branch, .threads = options_.threads});
    result.solution = equilibrium_solver_->solve(assembly_, control, check, first_iterate);
    mechanics::require_sensible_motion(result.solution);
    result.load_steps = {result.solution};
    is_at_equilibrium_ = result.solution.converged();
    report_.starting_point = equilibrium_solver_->starting_point();
}

void Session::Impl::solve_linear(SurfaceResult& result, const base::Control& control) {
    result.solution = updated_solver(control).solve(assembly_.loads, control);
    mechanics::require_sensible_motion(result.solution);
    is_at_equilibrium_ = result.solution.converged();
    linear_displacements_ = all_rows(result.solution);
}

SurfaceResult Session::Impl::solve(const base::Control& control, mechanics::StabilityCheck check,
                                   const mechanics::FirstIterate& first_iterate) {
    options_.validate(surface_);
    // A surface that cannot be a frame is refused before the work.
    std::optional<mechanics::Frame> frame;
    if (options_.estimate_error) frame = surface_frame(surface_, choice(), conditions_, control);
    const base::Stopwatch watch;
    is_at_equilibrium_ = false;
    update(control);
    are_tiles_solved_ = true;  // the receiver of the first iterate may ask for motions
    SurfaceResult result = make_result();
    const bool is_large = is_nonlinear();
    solved_in_ = is_large ? reduction::Displacements::Large : reduction::Displacements::Small;
    result.solver = is_large ? "newton" : "linear";
    if (is_large && options_.load_steps == 1) {
        solve_equilibrium(result, control, check, first_iterate);
    } else if (is_large) {
        solve_path(result, control);
    } else {
        solve_linear(result, control);
    }
    result.seconds = watch.seconds();
    if (frame) {
        const auto factors = mechanics::even_load_factors(options_.load_steps);
        result.discretization_error =
            mechanics::estimate_discretization_error(*frame, factors, result.load_steps,
                                                     {.threads = options_.threads, .control = control})
                .back();
    }
    if (options_.load_steps == 1) result.load_steps.clear();
    return result;
}

std::vector<TileDeformation> Session::Impl::tile_deformations(const mechanics::Solution& solution,
                                                              const base::Control& control) const {
    require_nodes(solution);
    return detail::tile_deformations(assembly_, starts_, solution, control);
}

void Session::Impl::require_nodes(const mechanics::Solution& solution) const {
    if (starts_.empty() || solution.displacements.rows() != Eigen::Index{assembly_.reported_nodes})
        throw base::InputError("this is no solution that the session gave; solve() gives one");
}

void Session::Impl::require_since_edit(const mechanics::Solution& solution) const {
    if (!are_tiles_solved_)
        throw base::InputError(
            "this is no solution that the session gave since its last edit; solve() gives one");
    require_nodes(solution);
}

reduction::TileMotion Session::Impl::tile_motion(TileIndex tile, const mechanics::Solution& solution) const {
    const std::size_t t = tile;
    return {
        .nodes = detail::rows_of_tile(solution.displacements, surface_.tessellation.tiles[t].interface_nodes,
                                      {starts_[t].inner_node, starts_[t + 1].inner_node}),
        .turn = tiles_[t].turn,
        .displacements = solved_in_};
}

std::optional<reduction::BeamMotion> Session::Impl::beam_motion(TileIndex tile,
                                                                const mechanics::Solution& solution) const {
    require_since_edit(solution);
    return tiles_[tile].structure->beam_motion(tile_motion(tile, solution));
}

std::optional<mechanics::NodeValues> Session::Impl::motion_gradient(
    TileIndex tile, const mechanics::Solution& solution, const mechanics::NodeValues& by_beams) const {
    require_since_edit(solution);
    return tiles_[tile].structure->motion_gradient(tile_motion(tile, solution), by_beams);
}

Eigen::MatrixXd Session::Impl::solve_adjoint(const Eigen::MatrixXd& rows, const base::Control& control) {
    update(control);
    const Eigen::Index own = Eigen::Index{assembly_.reported_nodes} * mechanics::kDofsPerNode;
    if (rows.rows() != own)
        throw base::InputError("the right sides have " + std::to_string(rows.rows()) +
                               " rows, where six are needed for each of the result's " +
                               std::to_string(assembly_.reported_nodes) + " nodes");
    // No loads act on the nodes inside beams, which a result leaves out.
    Eigen::MatrixXd all =
        Eigen::MatrixXd::Zero(std::ssize(assembly_.nodes) * mechanics::kDofsPerNode, rows.cols());
    all.topRows(own) = rows;
    return updated_solver(control).solve_free(all, control).topRows(own);
}

}  // namespace fretwork::simulation
