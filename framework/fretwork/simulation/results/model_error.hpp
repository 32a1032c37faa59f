// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/simulation/mixed_model.hpp>
#include <fretwork/simulation/results/stress_refinement.hpp>

#include <optional>
#include <span>
#include <string>

namespace fretwork::simulation {

/// The share of tiles in full in the better solution, from which errors are estimated. In
/// experiments/large_deflections, the estimate is below 0.7 of the true mean error on a tenth of the
/// surfaces. With a share of 5 %, it is below 0.7 on nearly half of them.
inline constexpr double kEstimatingShare = 0.3;
/// The additional share of tiles in full for mixed models. Their worst tiles are in full already, and the
/// rest of their error is spread over more tiles.
inline constexpr double kEstimatingShareOfMixed = 0.6;

/// rad, a limit of ModelDoubt::tile_rotation. If tiles are deformed farther, their errors are large, differ
/// in sign, and cancel: those of some of the tiles say nothing of the sum. Then all tiles are put in full,
/// which takes little longer than 60 % of them, and the difference is the error itself.
inline constexpr double kFarRotation = 0.3;

/// The model with which solutions of a model are compared: `mixed:SHARE`. The share is kEstimatingShare, for
/// mixed models their own and kEstimatingShareOfMixed more, and 1 beyond kFarRotation.
std::string better_model(const std::string& model, const ModelDoubt& doubt = {});

/// A solution of corotational tiles, of which the worst are in full.
struct BetterSolution {
    SurfaceResult result;
    std::vector<tiling::TileIndex> full_tiles;  ///< ascending
};
/// Solve a session of corotational or mixed tiles again, with more tiles in full: those of the model
/// better_model(). `own` is the session's last solution. Afterwards the session has corotational tiles, but
/// for these. If the corotational solution has not converged, that is the result.
BetterSolution better_solution(Session& session, const SurfaceResult& own, const ModelDoubt& doubt,
                               const base::Control& control = {});

/// The error of a solution of reduced tiles against the full model, estimated as its difference from a better
/// solution. None if one of the two has not converged. The stress is not compared.
std::optional<ModelError> model_error(const SurfaceResult& result, const SurfaceResult& better);
/// The same of solutions at the ends of stages, of which there are as many: the largest errors, as shares of
/// the largest displacement and norm at any of these ends. None unless all have converged.
std::optional<ModelError> staged_model_error(const SurfaceResult& result, const SurfaceResult& better);

/// Estimate the error of the largest von Mises stress of a table, as a share of it, from a refined solution
/// that began with the full tiles of the better model. None if a stress is not known.
std::optional<double> stress_error(const BeamTable& table, const RefinedStress& refined);
/// The same at the ends of stages, a table for each: the largest error, as a share of the largest stress at
/// any of these ends.
std::optional<double> staged_stress_error(std::span<const BeamTable> tables,
                                          std::span<const BeamTable> refined);

}  // namespace fretwork::simulation
