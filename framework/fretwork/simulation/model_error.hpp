// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/simulation/mixed_model.hpp>

#include <optional>

namespace fretwork::simulation {

/// The share of tiles in full with which solutions are compared.
inline constexpr double kEstimatingShare = 0.05;

/// How far a solution of reduced tiles is from the full model's, estimated as its difference from a better
/// one: corotational tiles with the worst 5 % in full. On the surfaces of experiments/large_deflections the
/// estimate is mostly within a third of the true error. None if the better one has not converged.
std::optional<mechanics::ModelError> model_error(const mechanics::Result& result,
                                                 const mechanics::Result& better);

}  // namespace fretwork::simulation
