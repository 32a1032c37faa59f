// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/linear_solver.hpp>
#include <fretwork/mechanics/paths/equilibrium_solver.hpp>
#include <fretwork/simulation/derivatives/sensitivity.hpp>
#include <fretwork/simulation/detail/joined_tiles.hpp>
#include <fretwork/simulation/load_cases/conditions.hpp>
#include <fretwork/simulation/session.hpp>

#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace fretwork::simulation {

/// The data of Session: the surface, the parts computed from it, and the parts that edits have made invalid.
/// Its model is a row of the tile models, never mixed.
class Session::Impl {
  public:
    Impl(Surface surface, LoadCase load_case, SimulationOptions options, CalibrationSource calibrations)
        : surface_(std::move(surface)),
          load_case_(std::move(load_case)),
          options_(std::move(options)),
          calibration_source_(std::move(calibrations)) {
        options_.validate(surface_);
        conditions_ = resolved(load_case_);
    }

    [[nodiscard]] const Surface& surface() const { return surface_; }
    [[nodiscard]] const LoadCase& load_case() const { return load_case_; }
    [[nodiscard]] const SimulationOptions& options() const { return options_; }
    [[nodiscard]] const Report& last_report() const { return report_; }

    void paint(std::span<const tiling::TileIndex> tiles, const std::string& id);
    void turn(std::span<const tiling::TileIndex> tiles, int vertices);
    void set_tile_model(std::span<const tiling::TileIndex> tiles, const std::string& name);
    void set_model(const std::string& name);
    void set_setting(const reduction::Setting& setting);
    void set_calibrations(std::vector<std::vector<reduction::Calibration>> calibrations);
    void set_load_case(const LoadCase& load_case);
    /// Refuse questions about the last solution. Tiles, and where the next solution starts, stay as they are.
    void forget_solution() { are_tiles_solved_ = is_at_equilibrium_ = false; }
    /// Throws InputError if tiles were edited after the last solve(), or as require_nodes().
    void require_since_edit(const mechanics::Solution& solution) const;

    SurfaceResult solve(const base::Control& control, mechanics::StabilityCheck check,
                        const mechanics::FirstIterate& first_iterate = {});
    [[nodiscard]] std::vector<TileDeformation> tile_deformations(const mechanics::Solution& solution,
                                                                 const base::Control& control) const;
    Linearization linearize(TileQuantities quantities, const base::Control& control);
    Eigen::MatrixXd solve_adjoint(const Eigen::MatrixXd& rows, const base::Control& control);
    [[nodiscard]] std::optional<reduction::BeamMotion> beam_motion(tiling::TileIndex tile,
                                                                   const mechanics::Solution& solution) const;
    [[nodiscard]] std::optional<mechanics::NodeValues> motion_gradient(
        tiling::TileIndex tile, const mechanics::Solution& solution,
        const mechanics::NodeValues& by_beams) const;
    [[nodiscard]] Sensitivity sensitivity(const mechanics::NodeValues& gradient,
                                          const base::Control& control);
    [[nodiscard]] mechanics::NodeValues energy_gradient(const mechanics::Solution& solution) const;

  private:
    [[nodiscard]] ModelChoice choice() const { return {options_.model, options_.models}; }
    [[nodiscard]] Conditions resolved(const LoadCase& load_case);
    void invalidate_tiles(std::span<const tiling::TileIndex> tiles);
    void invalidate_all_tiles();
    void update_masses();

    void update_tiles(const base::Control& control);
    void build_all(const base::Control& control);
    void join(std::vector<detail::BuiltTile> tiles, const base::Control& control);
    bool replace_elements(std::span<const tiling::TileIndex> tiles, std::span<const detail::BuiltTile> built);
    void update_conditions();
    void update(const base::Control& control);
    const mechanics::LinearSolver& updated_solver(const base::Control& control);
    [[nodiscard]] bool is_nonlinear() const;
    [[nodiscard]] SurfaceResult make_result() const;
    void solve_path(SurfaceResult& result, const base::Control& control) const;
    void solve_linear(SurfaceResult& result, const base::Control& control);
    void solve_equilibrium(SurfaceResult& result, const base::Control& control,
                           mechanics::StabilityCheck check, const mechanics::FirstIterate& first_iterate);

    /// The displacements of all nodes of the assembly: the reported ones, then the others.
    [[nodiscard]] static mechanics::NodeValues all_rows(const mechanics::Solution& solution);
    [[nodiscard]] reduction::TileMotion tile_motion(tiling::TileIndex tile,
                                                    const mechanics::Solution& solution) const;
    /// Throws InputError if the solution has other nodes than the assembly.
    void require_nodes(const mechanics::Solution& solution) const;
    [[nodiscard]] mechanics::NodeValues rest_forces(const mechanics::NodeValues& motions) const;
    [[nodiscard]] mechanics::NodeValues at_held(const mechanics::NodeValues& rows) const;
    [[nodiscard]] Sensitivity linear_sensitivity(const mechanics::NodeValues& gradient,
                                                 const base::Control& control) const;
    [[nodiscard]] TileLinearization linear_tile(tiling::TileIndex tile) const;
    /// The mass of a tile, kg; zero if gravity does not act.
    [[nodiscard]] double acting_mass(tiling::TileIndex tile) const {
        return tile_masses_ && !load_case_.gravity.isZero(0) ? (*tile_masses_)[tile] : 0.0;
    }
    [[nodiscard]] TileLinearization linearized_tile(tiling::TileIndex tile,
                                                    const mechanics::EquilibriumTangent& tangent) const;

    Surface surface_;
    LoadCase load_case_;
    SimulationOptions options_;
    CalibrationSource calibration_source_;
    Conditions conditions_;
    std::optional<std::vector<double>> tile_masses_;

    detail::TileBuilder builder_;
    std::vector<detail::BuiltTile> tiles_;       ///< empty: all are to be built
    std::set<tiling::TileIndex> changed_tiles_;  ///< built tiles that are to be built again
    std::vector<detail::TileStart> starts_;      ///< as JoinedTiles::starts
    mechanics::Assembly assembly_;
    std::size_t tile_supports_ = 0;  ///< number of the assembly's first supports, which are inside of tiles
    std::optional<mechanics::LinearSolver> solver_;
    std::optional<mechanics::EquilibriumSolver> equilibrium_solver_;
    Report report_;
    /// True if solve() has used the tiles, and no edit of tiles came after it.
    bool are_tiles_solved_ = false;
    /// True if the last solution, in one load step, has converged, and no edit came after it.
    bool is_at_equilibrium_ = false;
    mechanics::NodeValues linear_displacements_;  ///< last linear solution, for all nodes of the assembly
    /// Size of the displacements that the theory of the last solution allows.
    reduction::Displacements solved_in_ = reduction::Displacements::Small;
};

}  // namespace fretwork::simulation
