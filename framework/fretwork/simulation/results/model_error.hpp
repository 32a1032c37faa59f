// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/simulation/mixed_model.hpp>
#include <fretwork/simulation/results/stress_refinement.hpp>

#include <optional>
#include <string>

namespace fretwork::simulation {

/// The share of tiles in full with which solutions are compared. With 5 % in full, the difference is below
/// 0.7 of the true mean error on nearly half of the surfaces of experiments/large_deflections, with 30 % on a
/// tenth.
inline constexpr double kEstimatingShare = 0.3;
/// The same for mixed models, on top of their own share: they have the worst tiles in full already, and what
/// is left of their error is spread over more of the others.
inline constexpr double kEstimatingShareOfMixed = 0.6;

/// rad, ModelDoubt::tile_rotation: where tiles are deformed as far, what stays reduced with kEstimatingShare
/// in full can be as wrong as before, and the difference says nothing.
inline constexpr double kFarRotation = 0.3;

/// The model that solutions of a model are compared with: `mixed:SHARE`, with kEstimatingShare in full, or,
/// beyond kFarRotation and for mixed models, with kEstimatingShareOfMixed more than the model has itself.
std::string better_model(const std::string& model, const ModelDoubt& doubt = {});

/// The error of a solution of reduced tiles against the full model, estimated as its difference from a better
/// solution: corotational tiles with the worst kEstimatingShare in full. None if one of both has not
/// converged.
std::optional<ModelError> model_error(const SurfaceResult& result, const SurfaceResult& better);

/// The error of the largest von Mises stress of a table, as a share of it: against a refined solution, which
/// began with the tiles of that better one. None where a stress is not known.
std::optional<double> stress_error(const BeamTable& table, const RefinedStress& refined);

}  // namespace fretwork::simulation
