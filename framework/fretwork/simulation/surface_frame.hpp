// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/control.hpp>
#include <fretwork/simulation/load_cases/conditions.hpp>
#include <fretwork/simulation/model_choice.hpp>

#include <optional>

namespace fretwork::simulation {

/// The surface under a load case as a frame, for checks by other solvers. The first nodes of the frame are
/// the interface nodes. Throws InputError if a tile does not consist of beams (such as `condensed`), and as
/// tile_beams().
mechanics::Frame surface_frame(const Surface& surface, const ModelChoice& choice,
                               const Conditions& conditions, const base::Control& control = {});

/// The beams of the surface's tiles at rest, without supports and loads. The full model has the beams of the
/// patterns; a model like `paper6` has a few of its own. The first nodes are the interface nodes. Nothing if
/// any tile does not consist of beams. Throws InputError as tile_model() and tile_parameters(), and Stopped.
std::optional<mechanics::Frame> tile_beams(const Surface& surface, const ModelChoice& choice,
                                           const base::Control& control = {});

}  // namespace fretwork::simulation
