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

/// A function that gives a session the calibrations of a newly painted pattern, one for each tile model.
using CalibrationSource = std::function<std::vector<reduction::Calibration>(const std::string& pattern)>;

/// The deformation of a tile.
struct TileDeformation {
    double energy = 0.0;    ///< elastic energy, J
    double rotation = 0.0;  ///< largest rotation of a node relative to the tile's corotating axes, rad
};

/// A surface under a load case, for repeated edits and solutions. A session keeps all that it has computed:
/// the tiles, the assembled structure, the order of elimination, the factors, and the last nonlinear
/// equilibrium.
///
/// Edits build no tiles and solve nothing. The comment of each edit states the results that become invalid;
/// the next solve() computes only these again. A linear solution equals that of a new session on the edited
/// surface: bit by bit after a new factorization, within rounding after an update of the factors. A nonlinear
/// solution agrees with that of a new session within the solver's tolerance if there is only one stable
/// equilibrium. If there are several, the earlier equilibria determine which one is found
/// (mechanics::EquilibriumSolver). An edit that throws changes nothing.
///
/// The model `mixed:SHARE` (mixed_model.hpp) takes two solutions: one of corotational tiles only, and one in
/// which the worst tiles have all of their beams. A session keeps both and continues from both after an edit.
/// If other tiles become the worst, the second solution starts again.
///
/// Only one thread at a time may use a session, except for beam_motion() and motion_gradient().
/// SimulationOptions::models must live as long as the session.
class Session {
  public:
    /// Begin a session. If `calibrations` is empty, only the patterns of the given surface have calibrations.
    /// Throws InputError if the options or the load case are invalid for the surface.
    Session(Surface surface, LoadCase load_case, SimulationOptions options = {},
            CalibrationSource calibrations = {});
    Session(Session&&) noexcept;
    Session& operator=(Session&&) noexcept;
    ~Session();

    /// The surface after all edits.
    [[nodiscard]] const Surface& surface() const;
    /// The load case after all edits.
    [[nodiscard]] const LoadCase& load_case() const;
    /// The options, with the model after all edits.
    [[nodiscard]] const SimulationOptions& options() const;

    /// Paint tiles with a pattern, given by its id. Invalid after the edit: the painted tiles and, with
    /// gravity, the loads. Throws InputError as make_palette(), if a tile does not exist, or if the tile
    /// model needs a calibration that is missing; and as the CalibrationSource.
    void paint(std::span<const tiling::TileIndex> tiles, const std::string& pattern);
    /// Turn the patterns of tiles: vertex 0 moves by `vertices` vertices counterclockwise. Invalid after the
    /// edit: the same as after paint(). Throws InputError if a tile does not exist.
    void turn(std::span<const tiling::TileIndex> tiles, int vertices);
    /// Give tiles their own tile model; "" removes their own tile model. Invalid after the edit: these tiles.
    /// Throws InputError if a tile or the model does not exist, as tile_parameters(), or as
    /// SimulationOptions::validate().
    void set_tile_model(std::span<const tiling::TileIndex> tiles, const std::string& model);
    /// Replace the model of the tiles without their own tile model. Invalid after the edit: all tiles. If a
    /// mixed model replaces `corotational`, the next solve() uses the corotational tiles and their
    /// equilibrium. Throws InputError as SimulationOptions::validate(), or if a painted tile's model needs a
    /// calibration that is missing.
    void set_model(const std::string& model);
    /// Replace the setting (material, section, scenarios). Invalid after the edit: all tiles and, with
    /// gravity, the loads. The calibrations do not change; the caller has to replace them. Throws InputError
    /// if the setting is invalid, or if gravity acts and the material has no density.
    void set_setting(const reduction::Setting& setting);
    /// Replace the calibrations, given in the order of the surface's patterns. Invalid after the edit: all
    /// tiles. Throws InputError if the numbers of calibrations and patterns differ, or if a painted tile's
    /// model needs a calibration that is missing.
    void set_calibrations(std::vector<std::vector<reduction::Calibration>> calibrations);

    /// Replace the load case. Invalid after the edit: the loads and, if other dofs are held, the factors.
    /// Throws InputError as resolve().
    void set_load_case(const LoadCase& load_case);
    /// Replace one of the load case's supports, or append a support if `entry` is the number of supports.
    /// Invalid after the edit: the same as after set_load_case(). Throws as set_load_case(), and InputError
    /// if `entry` is above the number of supports.
    void set_support(std::size_t entry, const LoadCase::Support& support);
    /// Replace or append one of the load case's loads, as set_support() does with supports.
    void set_load(std::size_t entry, const LoadCase::Load& load);
    /// Replace or append one of the load case's prescribed displacements, as set_support() does with
    /// supports.
    void set_prescribed(std::size_t entry, const LoadCase::PrescribedDisplacement& displacement);

    /// Throws InputError before the first solve(), if tiles were edited after solve() gave the solution, if a
    /// mixed model has put other tiles in full since then, or if the solution has other nodes than the
    /// session's last one. A session knows its newest 10,000 solutions by their displacements; it does not
    /// check those of other sessions.
    void require_since_edit(const mechanics::Solution& solution) const;

    /// The tiles that have all of their beams in a mixed model after solve(), ascending; none for other
    /// models.
    [[nodiscard]] std::vector<tiling::TileIndex> full_tiles() const;
    /// The solution of corotational tiles that determined full_tiles() of a mixed model, after solve(). Null
    /// for other models.
    [[nodiscard]] const SurfaceResult* corotational_result() const;

    /// Solve for the equilibrium of the present surface. A linear solution uses the kept factors. A nonlinear
    /// solution starts from the last equilibrium if the options ask for the primary branch and one load step,
    /// the nodes are the same, and the last equilibrium is stable. In all other cases, it starts from rest;
    /// also if the equilibrium may lie on another path, or if new supports hold components far from their
    /// values. The result has no subject; result_subject() makes one.
    /// Throws InputError if a tile cannot be built after the edits, or if SimulationOptions::estimate_error
    /// is set and a tile does not consist of beams; NumericalError if the structure has too few supports, or
    /// as mechanics::require_sensible_motion(); base::Stopped. After an error, all edits are kept, and the
    /// next call continues.
    ///
    /// @param check  whether to check the stability; Skipped is for a user who drags a load in small steps,
    /// and is ignored by linear solutions and by paths of several load steps
    /// @param first_iterate  receiver of the first iterate of a nonlinear solution that starts from the last
    /// equilibrium; not called for mixed models and linear solutions; may be empty
    SurfaceResult solve(const base::Control& control = {},
                        mechanics::StabilityCheck check = mechanics::StabilityCheck::Made,
                        const mechanics::FirstIterate& first_iterate = {});

    /// The linear displacements K^-1 g under nodal loads g, the columns of `rows`, in linear theory for every
    /// model. Supported and prescribed components are held at zero. If g is the gradient of a function, the
    /// result is the adjoint of this function. Columns have 6n rows, node by node, for the n nodes of the
    /// result. Throws InputError if the number of rows is wrong, and as solve().
    Eigen::MatrixXd solve_adjoint(const Eigen::MatrixXd& rows, const base::Control& control = {});

    /// Linearize the surface at the nonlinear equilibrium of the last solve(); derivatives
    /// (derivatives/sensitivity.hpp) need it. The linearization reuses the solution's factors, if any, and is
    /// valid until the next edit or solve(). Throws InputError if there is no such equilibrium, if an edit
    /// came after it, or if it was reached in several load steps; NumericalError if the tangent is singular
    /// at the equilibrium; Stopped.
    [[nodiscard]] Linearization linearize(TileQuantities quantities = TileQuantities::Strains,
                                          const base::Control& control = {});
    /// The derivatives of a function J of the displacements at the equilibrium of the last solve(), linear or
    /// nonlinear, with respect to loads, held values and tiles. In a linear solution, the strains of a tile
    /// are its displacements in its own axes. Throws as linearize(), and InputError if the number of rows of
    /// `gradient` is wrong.
    /// @param gradient  the derivatives of J with respect to displacements and rotation vectors, one row for
    /// each node of the result
    [[nodiscard]] Sensitivity sensitivity(const mechanics::NodeValues& gradient,
                                          const base::Control& control = {});
    /// The gradient of the elastic energy with respect to displacements and rotation vectors (N, N m), one
    /// row for each node of a solution since the session's last edit. Its first three columns equal the
    /// internal forces; in a nonlinear solution, the other three differ from the internal moments, because
    /// rotation vectors are not spins. Throws as require_since_edit().
    [[nodiscard]] mechanics::NodeValues energy_gradient(const mechanics::Solution& solution) const;

    /// The deformation of each tile in a solution of this session; zero for tiles made of beams. Throws
    /// InputError if the solution has other nodes than the session's last one; Stopped.
    [[nodiscard]] std::vector<TileDeformation> tile_deformations(const mechanics::Solution& solution,
                                                                 const base::Control& control = {}) const;

    /// The motions of a tile's beams in a solution since the session's last edit; nothing if the tile's model
    /// does not give them. Throws InputError if tiles were edited after the last solve(), or if the solution
    /// has other nodes than the session's last one. Several threads may call this function and
    /// motion_gradient() at once.
    [[nodiscard]] std::optional<reduction::BeamMotion> beam_motion(tiling::TileIndex tile,
                                                                   const mechanics::Solution& solution) const;
    /// The gradient of a function of beam_motion() with respect to the rows of the tile's interface nodes;
    /// see reduction::TileStructure::motion_gradient(). Nothing if the tile's model does not give it. Throws
    /// as beam_motion().
    [[nodiscard]] std::optional<mechanics::NodeValues> motion_gradient(
        tiling::TileIndex tile, const mechanics::Solution& solution,
        const mechanics::NodeValues& by_beams) const;

    /// The computed and the reused parts of the last solve() or solve_adjoint(); of a mixed model, only of
    /// the last solve().
    struct Report {
        std::size_t tiles_built = 0;  ///< number of tiles built; a shared tile counts once
        /// The effect on the factors.
        using Factors = mechanics::FactorChange;
        Factors factors = Factors::Refactorized;  ///< effect on the factors of a linear solution
        /// The state from which a nonlinear solution started.
        mechanics::StartingPoint starting_point = mechanics::StartingPoint::Rest;
    };
    /// The report of the last solve() or solve_adjoint().
    [[nodiscard]] const Report& last_report() const;

  private:
    class Impl;
    class Mixture;
    class GivenSolutions;
    template <class Edit>
    void edit(const Edit& edit);
    template <class Edit>
    void edit_tiles(const Edit& change);
    [[nodiscard]] Impl& answering() const;

    std::unique_ptr<Impl> impl_;
    /// For mixed models, where `impl_` has only corotational tiles; null for other models.
    std::unique_ptr<Mixture> mixture_;
    std::unique_ptr<GivenSolutions> given_;
};

}  // namespace fretwork::simulation
