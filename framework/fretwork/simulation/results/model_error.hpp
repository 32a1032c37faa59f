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
/// surfaces. With a share of 5 %, the estimate is below 0.7 times the true mean error on nearly half of the
/// surfaces.
inline constexpr double kEstimatingShare = 0.3;
/// The additional share of tiles with all of their beams if the solution is of a mixed model. In a mixed
/// model, the worst tiles have all of their beams already, and the remaining error is spread over more tiles.
inline constexpr double kEstimatingShareOfMixed = 0.6;

/// The limit of ModelDoubt::tile_rotation, rad, above which the better solution has all beams of all tiles.
/// Above the limit, the errors of tiles are large, differ in sign, and cancel, so the errors of some tiles do
/// not determine the sum of the errors. A solution with all beams of all tiles takes little longer than with
/// all beams of 60 % of the tiles, and the difference from it is the error itself.
inline constexpr double kFarRotation = 0.3;

/// The share of tiles with all of their beams in the better solution, with which a solution of `model` is
/// compared. The share is kEstimatingShare. For a mixed model, the share is the model's own share plus
/// kEstimatingShareOfMixed. Above kFarRotation, the share is 1.
double better_share(const std::string& model, const ModelDoubt& doubt = {});

/// A solution of corotational tiles, where the worst tiles have all of their beams.
struct BetterSolution {
    SurfaceResult result;                       ///< the solution
    std::vector<tiling::TileIndex> full_tiles;  ///< tiles with all of their beams, ascending
};
/// Solve a session of corotational or mixed tiles again with better_share(), where more tiles have
/// all of their beams. `own` is the session's last solution. After the call, the session keeps these tiles
/// with all of their beams, and all other tiles are corotational. If the corotational solution has not
/// converged, it is returned.
BetterSolution better_solution(Session& session, const SurfaceResult& own, const ModelDoubt& doubt,
                               const base::Control& control = {});

/// True if the session that estimates the error of a solution with `options` begins with that solution,
/// because its tiles are corotational or mixed.
bool begins_with_own_solution(const Surface& surface, const SimulationOptions& options);
/// The options of that session: `options` if it begins with that solution, otherwise options of corotational
/// tiles.
SimulationOptions estimating_options(const Surface& surface, SimulationOptions options);
/// Estimate the error of a result, and of its largest stress, from the better solution that follows after
/// `turned`, the last solution of a session with estimating_options(). None if a solution has not converged.
/// Pre: the result is one of the surface, and has a subject.
std::optional<ModelError> estimate_model_error(Session& session, const SurfaceResult& turned,
                                               const ModelDoubt& doubt, const Surface& surface,
                                               const SurfaceResult& result,
                                               const base::Control& control = {});

/// The error of a solution of reduced tiles against the full model, estimated as its difference from a better
/// solution. None if one of the two solutions has not converged. The stress is not compared.
std::optional<ModelError> model_error(const SurfaceResult& result, const SurfaceResult& better);
/// The share of a surface's tiles that a list holds.
double share_of(std::span<const tiling::TileIndex> tiles, const Surface& surface);
/// The error of solutions at the ends of load stages against the full model, estimated as by model_error():
/// the largest errors, as shares of the largest displacement and norm at the end of any load stage. None
/// unless all solutions have converged. Pre: both results have the same number of load stages.
std::optional<ModelError> staged_model_error(const SurfaceResult& result, const SurfaceResult& better);

/// Estimate the relative error of the largest von Mises stress of a table from a refined solution, which
/// began with the full tiles of the better model. None if a stress is not known.
std::optional<double> stress_error(const BeamTable& table, const RefinedStress& refined);
/// Estimate the error of the largest von Mises stress at the ends of load stages, with one table for each
/// load stage: the largest error, as a share of the largest stress at the end of any load stage.
std::optional<double> staged_stress_error(std::span<const BeamTable> tables,
                                          std::span<const BeamTable> refined);

}  // namespace fretwork::simulation
