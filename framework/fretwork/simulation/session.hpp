// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/control.hpp>
#include <fretwork/mechanics/linear_solver.hpp>
#include <fretwork/mechanics/paths/equilibrium_solver.hpp>
#include <fretwork/simulation/derivatives/linearization.hpp>
#include <fretwork/simulation/load_cases/load_case.hpp>
#include <fretwork/simulation/results/surface_result.hpp>
#include <fretwork/simulation/simulation_options.hpp>
#include <fretwork/simulation/surface.hpp>

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace fretwork::simulation {

struct Sensitivity;

/// Gives a session the calibrations of a newly painted pattern, one for each tile model.
using CalibrationSource = std::function<std::vector<reduction::Calibration>(const std::string& pattern)>;

/// The deformation of a tile.
struct TileDeformation {
    double energy = 0.0;    ///< J
    double rotation = 0.0;  ///< rad, largest rotation of a node relative to the tile's corotating axes
};

/// A surface under a load case, for repeated edits and solutions. A session keeps what it has computed: the
/// tiles, the assembled structure, the order of elimination, the factors, and the last nonlinear equilibrium.
///
/// Edits compute nothing. The comment of each edit states what it invalidates, and the next solve() computes
/// only that. After any edits, a linear solution equals that of a new session on the edited surface: it has
/// the same bits after a new factorization, and agrees within rounding after an update of the factors. A
/// nonlinear solution agrees within the solver's tolerance if the loads have only one stable equilibrium;
/// otherwise it is the equilibrium to which the edits have led (mechanics::EquilibriumSolver). An edit that
/// throws changes nothing.
///
/// The model `mixed:SHARE` (mixed_model.hpp) takes two solutions: one with corotational tiles only, and one
/// with the worst of these in full. A session keeps both and continues from both after an edit. It starts the
/// second one again if other tiles become the worst.
///
/// Only one thread at a time may use a session. SimulationOptions::models must live as long as the session.
class Session {
  public:
    /// `calibrations` may be empty; then only the surface's own patterns have calibrations. Throws InputError
    /// if the options or the load case are invalid for the surface.
    Session(Surface surface, LoadCase load_case, SimulationOptions options = {},
            CalibrationSource calibrations = {});
    Session(Session&&) noexcept;
    Session& operator=(Session&&) noexcept;
    ~Session();

    /// The surface as it is after all edits.
    [[nodiscard]] const Surface& surface() const;
    /// The load case as it is after all edits.
    [[nodiscard]] const LoadCase& load_case() const;
    /// The options, with the model as it is after all edits.
    [[nodiscard]] const SimulationOptions& options() const;

    /// Paint tiles with a pattern, given by its id. Invalid: these tiles, and with gravity the loads. Throws
    /// InputError as make_palette does, or if the tile model needs a calibration that is missing.
    void paint(std::span<const tiling::TileIndex> tiles, const std::string& pattern);
    /// Turn the patterns of tiles: vertex 0 moves by `vertices` vertices counterclockwise. Invalid: as
    /// paint().
    void turn(std::span<const tiling::TileIndex> tiles, int vertices);
    /// Give tiles their own tile model; "" removes it. Invalid: these tiles.
    void set_tile_model(std::span<const tiling::TileIndex> tiles, const std::string& model);
    /// Replace the model of the tiles without their own. Invalid: all tiles.
    void set_model(const std::string& model);
    /// Replace the setting (material, section, scenarios). Invalid: all tiles and, with gravity, the loads.
    /// Calibrations stay; the caller has to replace them. Throws InputError if the setting is invalid, or has
    /// no mass for the load case's gravity.
    void set_setting(const reduction::Setting& setting);
    /// Replace the calibrations, in the order of the surface's patterns. Invalid: all tiles. Throws
    /// InputError if their number is not that of the patterns, or a painted tile's model needs one that is
    /// missing.
    void set_calibrations(std::vector<std::vector<reduction::Calibration>> calibrations);

    /// Replace the load case. Invalid: the loads, and the factors if other dofs are held than before.
    void set_load_case(const LoadCase& load_case);
    /// Change one entry of the load case, or append one, if `entry` is the number of entries. Invalid: as
    /// set_load_case().
    void set_support(std::size_t entry, const LoadCase::Support& support);
    /// Change an entry of the load case's loads.
    void set_load(std::size_t entry, const LoadCase::Load& load);
    /// Change an entry of its prescribed displacements.
    void set_prescribed(std::size_t entry, const LoadCase::PrescribedDisplacement& displacement);

    /// The tiles that a mixed model has in full after solve(), ascending; none for other models.
    [[nodiscard]] std::vector<tiling::TileIndex> full_tiles() const;
    /// The solution with corotational tiles from which a mixed model chose full_tiles(), after solve(). Null
    /// for other models.
    [[nodiscard]] const SurfaceResult* corotational_result() const;

    /// Solve for the equilibrium of the present surface. A linear solution uses the kept factors. A nonlinear
    /// solution starts from the last equilibrium if the nodes are the same and the options ask for one load
    /// step. Otherwise, and if the equilibrium may lie on another path, it starts from rest. The result has
    /// no subject; result_subject() makes it. Throws InputError if a tile cannot be built after the edits,
    /// NumericalError if the structure has too few supports, and base::Stopped; then all edits are kept, and
    /// the next call continues. StabilityCheck::Left is for loads that a user drags in small steps. Linear
    /// solutions, and paths of several load steps, ignore it.
    ///
    /// @param first_iterate  called during solve() with the first iterate of a nonlinear solution that starts
    /// from the last equilibrium; not called for mixed models and linear solutions; may be empty
    SurfaceResult solve(const base::Control& control = {},
                        mechanics::StabilityCheck check = mechanics::StabilityCheck::Made,
                        const mechanics::FirstIterate& first_iterate = {});

    /// The linear displacements K^-1 g under nodal loads g, one column each, with the supports of the load
    /// case and without prescribed displacements. With the gradient of a target as g, they are its adjoint.
    /// Columns have 6n rows, node by node, for the n nodes of the result. Throws InputError if the number of
    /// rows is wrong, and as solve().
    Eigen::MatrixXd solve_adjoint(const Eigen::MatrixXd& rows, const base::Control& control = {});

    /// Linearize the surface at the nonlinear equilibrium of the last solve(); derivatives
    /// (derivatives/sensitivity.hpp) need it. Pre: no edit since then. It reuses the solution's factors, and
    /// is valid until the next edit or solve(). Throws InputError if there is no such equilibrium, or if it
    /// was reached in several load steps; NumericalError if the tangent is singular there; Stopped.
    [[nodiscard]] Linearization linearize(TileQuantities quantities = TileQuantities::Strains,
                                          const base::Control& control = {});
    /// The derivatives of a function J of the displacements by all that the equilibrium of the last solve()
    /// depends on, linear or nonlinear. Strains of a linear solution are displacements in a tile's own axes.
    /// @param gradient  dJ by displacements and rotation vectors, a row for each node of the result
    /// Throws as linearize(), and InputError if the rows are not as many.
    [[nodiscard]] Sensitivity sensitivity(const mechanics::NodeValues& gradient,
                                          const base::Control& control = {});
    /// The gradient of the elastic energy by displacements and rotation vectors (N, N m), a row for each node
    /// of a solution that this session gave since the last edit: its internal forces.
    [[nodiscard]] mechanics::NodeValues energy_gradient(const mechanics::Solution& solution) const;

    /// The deformation of each tile in a solution of this session; zero for tiles made of beams.
    [[nodiscard]] std::vector<TileDeformation> tile_deformations(const mechanics::Solution& solution) const;

    /// The motions of a tile's beams in a solution that this session gave since the last edit; nothing if its
    /// model does not give them. Several threads may call it at once.
    [[nodiscard]] std::optional<reduction::BeamMotion> beam_motion(tiling::TileIndex tile,
                                                                   const mechanics::Solution& solution) const;
    /// The gradient of a function of that motion by the rows of the tile's interface nodes:
    /// reduction::TileStructure::motion_gradient. Nothing if the tile's model does not give it.
    [[nodiscard]] std::optional<mechanics::NodeValues> motion_gradient(
        tiling::TileIndex tile, const mechanics::Solution& solution,
        const mechanics::NodeValues& by_beams) const;

    /// The report of the last solve() or solve_adjoint(): what it computed and what it reused.
    struct Work {
        std::size_t tiles_built = 0;  ///< a shared tile counts once
        /// What became of the factors.
        using Factors = mechanics::FactorChange;
        Factors factors = Factors::Refactorized;  ///< for a linear solution
        /// For a nonlinear solution: the state from which it started.
        mechanics::StartingPoint starting_point = mechanics::StartingPoint::Rest;
    };
    /// What the last solve() did.
    [[nodiscard]] const Work& last_work() const;

  private:
    class Impl;
    class Mixture;
    template <class Edit>
    void edit(const Edit& edit);
    [[nodiscard]] Impl& answering() const;

    std::unique_ptr<Impl> impl_;
    std::unique_ptr<Mixture> mixture_;  ///< for mixed models; `impl_` then has only the corotational tiles
};

}  // namespace fretwork::simulation
