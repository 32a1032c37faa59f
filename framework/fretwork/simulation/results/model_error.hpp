// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/simulation/mixed_model.hpp>
#include <fretwork/simulation/results/stress_refinement.hpp>

#include <optional>
#include <string>

namespace fretwork::simulation {

/// The share of tiles in full in the better solution, from which errors are estimated. In
/// experiments/large_deflections, the estimate is below 0.7 of the true mean error on a tenth of the
/// surfaces. With a share of 5 %, it is below 0.7 on nearly half of them.
inline constexpr double kEstimatingShare = 0.3;
/// The additional share of tiles in full for mixed models. Their worst tiles are in full already, and the
/// rest of their error is spread over more tiles.
inline constexpr double kEstimatingShareOfMixed = 0.6;

/// A limit of ModelDoubt::tile_rotation, rad. Beyond it, the tiles that stay reduced in the better solution
/// can be as wrong as before, and the difference does not show the error.
inline constexpr double kFarRotation = 0.3;

/// The better model for estimating the error of a model: `mixed:SHARE`. The share is kEstimatingShare. For
/// mixed models, and beyond kFarRotation, it is the model's own share plus kEstimatingShareOfMixed.
std::string better_model(const std::string& model, const ModelDoubt& doubt = {});

/// Estimate the error of a solution of reduced tiles relative to the full model, as its difference from a
/// better solution (better_model). None if one of the two did not converge.
std::optional<ModelError> model_error(const SurfaceResult& result, const SurfaceResult& better);

/// Estimate the error of the largest von Mises stress of a table, as a share of it, from a refined solution
/// that began with the full tiles of the better model. None if a stress is not known.
std::optional<double> stress_error(const BeamTable& table, const RefinedStress& refined);

}  // namespace fretwork::simulation
