// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/simulation/mixed_model.hpp>
#include <fretwork/simulation/results/stress_refinement.hpp>

#include <optional>
#include <span>
#include <string>

namespace fretwork::simulation {

/// The share of tiles with all of their beams in the better solution, from which errors are estimated. In
/// experiments/large_deflections, the estimate is below 0.7 times the true mean error on a tenth of the
/// surfaces. With a share of 5 %, this is so on nearly half of them.
inline constexpr double kEstimatingShare = 0.3;
/// The additional share for solutions of a mixed model. There, the worst tiles have all of their beams
/// already, and the remaining error is spread over more tiles.
inline constexpr double kEstimatingShareOfMixed = 0.6;

/// The better solution has all beams of all tiles if ModelDoubt::tile_rotation (rad) exceeds this limit. The
/// errors of tiles are then large, differ in sign and cancel, so the errors of some tiles do not determine
/// their sum. A solution with all beams of all tiles takes little longer than with all beams of 60 % of the
/// tiles, and the difference from it is the error itself.
inline constexpr double kFarRotation = 0.3;

/// The share of tiles with all of their beams in the better solution for a solution of `model`:
/// kEstimatingShare; for a mixed model, its own share plus kEstimatingShareOfMixed, at most 1; above
/// kFarRotation, 1.
double better_share(const std::string& model, const ModelDoubt& doubt = {});

/// A solution of corotational tiles in which the worst tiles have all of their beams.
struct BetterSolution {
    SurfaceResult result;                       ///< the solution
    std::vector<tiling::TileIndex> full_tiles;  ///< tiles with all of their beams, ascending
};
/// Solve a session of corotational or mixed tiles again, with all beams in the worst tiles; their share is
/// better_share(). `own` is the session's last solution. The session keeps these tiles with all of their
/// beams, and its model is then `corotational`. If the corotational solution has not converged, it is
/// returned, and the session does not change. Throws as Session::solve().
BetterSolution better_solution(Session& session, const SurfaceResult& own, const ModelDoubt& doubt,
                               const base::Control& control = {});

/// True if the estimate of a solution's error begins with that solution: a nonlinear solution of the model
/// `corotational` or of a mixed model. Throws InputError if a model is unknown.
bool begins_with_own_solution(const Surface& surface, const SimulationOptions& options);
/// The options of the session that estimates the error: `options` if begins_with_own_solution(), otherwise
/// options of corotational tiles.
SimulationOptions estimating_options(const Surface& surface, SimulationOptions options);
/// Estimate the error of a result, and of its largest stress, from a better solution of a session with
/// estimating_options(). None if a solution has not converged. Throws as Session::solve() and compare(). Pre:
/// the result belongs to the surface and has a subject.
/// @param turned  the last solution of the session
/// @param doubt  the indicators of `turned`, for better_share()
std::optional<ModelError> estimate_model_error(Session& session, const SurfaceResult& turned,
                                               const ModelDoubt& doubt, const Surface& surface,
                                               const SurfaceResult& result,
                                               const base::Control& control = {});

/// Estimate the error of a solution of reduced tiles, relative to the full model, by its difference from a
/// better solution. None if one of the two has not converged. Stresses are not compared. Throws as compare().
std::optional<ModelError> model_error(const SurfaceResult& result, const SurfaceResult& better);
/// The share of a surface's tiles in a list.
double share_of(std::span<const tiling::TileIndex> tiles, const Surface& surface);
/// Estimate the errors of solutions at the ends of load stages as in model_error(). The result has the
/// largest errors, as shares of the largest displacement and norm at the end of any load stage. None if a
/// solution has not converged, or if the results differ in the number of load stages. Throws as compare().
std::optional<ModelError> staged_model_error(const SurfaceResult& result, const SurfaceResult& better);

/// Estimate the relative error of the largest von Mises stress of a table from a refined solution that began
/// with the full tiles of the better solution. None if the refinement is not settled, or if the table has
/// unknown beams or no beams.
std::optional<double> stress_error(const BeamTable& table, const RefinedStress& refined);
/// Estimate the error of the largest von Mises stress at the ends of load stages, from one table for each
/// load stage. The result is the largest error, as a share of the largest stress at the end of any load
/// stage; none if a table has unknown beams or no beams.
std::optional<double> staged_stress_error(std::span<const BeamTable> tables,
                                          std::span<const BeamTable> refined);

}  // namespace fretwork::simulation
