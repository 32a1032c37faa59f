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

/// Where a session finds the calibrations of patterns that come in by painting, one for each tile model.
using CalibrationSource = std::function<std::vector<reduction::Calibration>(const std::string& pattern)>;

/// How far a tile is deformed.
struct TileDeformation {
    double energy = 0.0;    ///< J
    double rotation = 0.0;  ///< rad, the largest of a node against the tile's frame
};

/// A surface under a load case that is edited and solved again and again. It keeps what was computed: the
/// tiles, the assembled structure, the order of elimination and the factors, and the last nonlinear
/// equilibrium.
///
/// Edits compute nothing. Each documents what it invalidates, and the next solve() computes only that. After
/// any edits the answer is that of the edited surface simulated from nothing: the same bits after a new
/// factorization, and within rounding after an update of the factors. A nonlinear answer agrees with that
/// from nothing within the solver's tolerance if the loads have only one stable equilibrium; otherwise it is
/// the one to which the edits have led (mechanics::EquilibriumSolver). An edit that throws has changed
/// nothing.
///
/// The model `mixed:SHARE` (mixed_model.hpp) takes two solutions: of corotational tiles, and with the worst
/// of these in full. A session keeps both, so that edits go on from both, and starts the second one again
/// where other tiles are the worst.
///
/// Not from several threads at once. SimulationOptions::models must live as long as the session.
class Session {
  public:
    /// `calibrations` may be empty: then only the surface's own patterns have any. Throws InputError if the
    /// options or the load case are invalid for the surface.
    Session(Surface surface, LoadCase load_case, SimulationOptions options = {},
            CalibrationSource calibrations = {});
    Session(Session&&) noexcept;
    Session& operator=(Session&&) noexcept;
    ~Session();

    [[nodiscard]] const Surface& surface() const;
    [[nodiscard]] const LoadCase& load_case() const;
    [[nodiscard]] const SimulationOptions& options() const;

    /// Paint tiles with a pattern, given by its id. Invalid: these tiles, and with gravity the loads. Throws
    /// InputError as make_palette does, or if the tile model needs a calibration that is not there.
    void paint(std::span<const tiling::TileIndex> tiles, const std::string& pattern);
    /// Turn the patterns of tiles: their first vertex moves on by `vertices`. Invalid: as paint().
    void turn(std::span<const tiling::TileIndex> tiles, int vertices);
    /// Give tiles their own tile model; "" takes it back. Invalid: these tiles.
    void set_tile_model(std::span<const tiling::TileIndex> tiles, const std::string& model);
    /// Invalid: all tiles.
    void set_model(const std::string& model);
    /// Other material, section or scenarios. Invalid: all tiles and, with gravity, the loads. Calibrations
    /// stay: they are the caller's to replace. Throws InputError if the setting is invalid, or has no mass
    /// for the load case's gravity.
    void set_setting(const reduction::Setting& setting);
    /// Other calibrations, for each pattern of the surface in turn. Invalid: all tiles. Throws InputError if
    /// they are not as many, or a painted tile's model needs one that is not there.
    void set_calibrations(std::vector<std::vector<reduction::Calibration>> calibrations);

    /// Invalid: the loads; the factors if other dofs are held than before.
    void set_load_case(const LoadCase& load_case);
    /// Change one entry of the load case, or append one (`entry` is then their number). As set_load_case.
    void set_support(std::size_t entry, const LoadCase::Support& support);
    void set_load(std::size_t entry, const LoadCase::Load& load);
    void set_prescribed(std::size_t entry, const LoadCase::PrescribedDisplacement& displacement);

    /// The tiles that a mixed model has put in full, after solve(), ascending; none for other models.
    [[nodiscard]] std::vector<tiling::TileIndex> full_tiles() const;
    /// The solution with corotational tiles by which a mixed model chose those, after solve(). Null for other
    /// models.
    [[nodiscard]] const SurfaceResult* corotational_result() const;

    /// The equilibrium of the surface as it is now. A linear one uses the kept factors. A nonlinear one
    /// starts from the last equilibrium, if the nodes are the same and one load step is asked for; otherwise,
    /// and where it may lie on another path, from rest. The result has no subject: result_subject() gives it.
    /// Throws InputError if an edit has left what cannot be built, NumericalError if the structure is not
    /// held, and base::Stopped; then all edits are kept, and the next call goes on. StabilityCheck::Left is
    /// for loads that are dragged in small steps. Linear solutions, and paths of several load steps, ignore
    /// it.
    ///
    /// @param first_iterate  receives, within the call, the first iterate of a nonlinear solution that starts
    /// from the last equilibrium; mixed models and linear solutions do not call it. May be empty.
    SurfaceResult solve(const base::Control& control = {},
                        mechanics::StabilityCheck check = mechanics::StabilityCheck::Made,
                        const mechanics::FirstIterate& first_iterate = {});

    /// The linear displacements under nodal loads g, one column each (6n rows: node by node of the result's n
    /// nodes), with the supports of the load case and nothing prescribed: K^-1 g, for instance the adjoint of
    /// a target. Throws InputError if the rows are not as many, and as solve().
    Eigen::MatrixXd solve_adjoint(const Eigen::MatrixXd& rows, const base::Control& control = {});

    /// The surface to first order at the nonlinear equilibrium of the last solve(), to which the edits since
    /// then must be none: what derivatives (derivatives/sensitivity.hpp) stand on. It reuses that solution's
    /// factors, and is valid until the next edit or solve(). Throws InputError if there is no such
    /// equilibrium, or if it was reached in several load steps; NumericalError if it is at a limit of its
    /// stability; Stopped.
    [[nodiscard]] Linearization linearize(TileQuantities quantities = TileQuantities::Strains,
                                          const base::Control& control = {});
    /// The derivatives of a function J of the displacements there by all that the equilibrium depends on.
    /// @param gradient  dJ by displacements and rotation vectors, a row for each node of the result
    /// Throws as linearize(), and InputError if the rows are not as many.
    [[nodiscard]] Sensitivity sensitivity(const mechanics::NodeValues& gradient,
                                          const base::Control& control = {});

    /// How far each tile is deformed in a solution of this session; zero for tiles made of beams.
    [[nodiscard]] std::vector<TileDeformation> tile_deformations(const mechanics::Solution& solution) const;

    /// The motions of a tile's beams in a solution that this session gave since the last edit; nothing if its
    /// model does not give them. Several threads may ask at once.
    [[nodiscard]] std::optional<reduction::BeamMotion> beam_motion(tiling::TileIndex tile,
                                                                   const mechanics::Solution& solution) const;

    /// The work of the last solve() or solve_adjoint(): what it computed, and what it reused.
    struct Work {
        std::size_t tiles_built = 0;  ///< shared ones once
        using Factors = mechanics::FactorChange;
        Factors factors = Factors::Refactorized;  ///< of a linear solution
        /// For a nonlinear solution: the state to go on from.
        mechanics::StartingPoint starting_point = mechanics::StartingPoint::Rest;
    };
    [[nodiscard]] const Work& last_work() const;

  private:
    class Impl;
    class Mixture;
    template <class Edit>
    void edit(const Edit& edit);
    [[nodiscard]] Impl& answering() const;

    std::unique_ptr<Impl> impl_;
    std::unique_ptr<Mixture> mixture_;  ///< of mixed models; `impl_` then has the corotational tiles alone
};

}  // namespace fretwork::simulation
