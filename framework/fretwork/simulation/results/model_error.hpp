// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/simulation/mixed_model.hpp>
#include <fretwork/simulation/results/stress_refinement.hpp>

#include <optional>
#include <string>

namespace fretwork::simulation {

/// The share of tiles in full in the solution with which others are compared. With 5 %, the difference is
/// below 0.7 of the true mean error on nearly half of the surfaces of experiments/large_deflections; with 30
/// %, on a tenth of them.
inline constexpr double kEstimatingShare = 0.3;
/// The same for mixed models, in addition to their own share: their worst tiles are in full already, and the
/// rest of their error is spread over more tiles.
inline constexpr double kEstimatingShareOfMixed = 0.6;

/// rad, a limit of ModelDoubt::tile_rotation. If tiles are deformed farther, those that stay reduced with
/// kEstimatingShare in full can be as wrong as before, and the difference says nothing.
inline constexpr double kFarRotation = 0.3;

/// The model with which solutions of a model are compared: `mixed:SHARE`. The share is kEstimatingShare;
/// beyond kFarRotation and for mixed models, it is the model's own share and kEstimatingShareOfMixed more.
std::string better_model(const std::string& model, const ModelDoubt& doubt = {});

/// The error of a solution of reduced tiles against the full model, estimated as its difference from a better
/// solution: corotational tiles with the worst kEstimatingShare in full. None if one of the two has not
/// converged.
std::optional<ModelError> model_error(const SurfaceResult& result, const SurfaceResult& better);

/// The error of the largest von Mises stress of a table, as a share of it, estimated against a refined
/// solution that began with the full tiles of the better model. None if a stress is not known.
std::optional<double> stress_error(const BeamTable& table, const RefinedStress& refined);

}  // namespace fretwork::simulation
