// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/simulation/session.hpp>

#include <span>
#include <string>

namespace fretwork::simulation {

/// The first two of three limits of ModelDoubt: rad, and a share of the largest displacement. Above one of
/// the three, the error is estimated. In experiments/error_warnings, every result with an error of 5 % at its
/// worst node is above one of them.
inline constexpr double kDoubtfulRotation = 0.09;
/// The limit of a mixed answer's change, of the largest displacement.
inline constexpr double kDoubtfulChange = 0.03;
/// Linear solves from rest. A path with more of them has passed places where small differences decide. Of
/// stages they say nothing: there, a jump is such a place.
inline constexpr int kDoubtfulIterations = 40;
/// An error above this gives a warning: at the worst node, as a share of the largest displacement. If it was
/// estimated with some of the tiles in full, less does, since the estimate may be too small by a third.
inline constexpr double kWarnedError = 0.05;
inline constexpr double kWarnedEstimate = 0.03;

/// The indicators of the last solution of a session, which must be nonlinear.
ModelDoubt model_doubt(const Session& session, const SurfaceResult& result);
/// The indicators of a solution with these deformations of its tiles.
ModelDoubt model_doubt(std::span<const TileDeformation> tiles);

/// True if an indicator of a result is above its limit, so that the error has to be estimated.
bool is_doubtful(const SurfaceResult& result);

/// The warning about a converged result whose estimated error is large, or whose error is not known and may
/// be large. Empty if there is no reason to warn.
std::string model_warning(const SurfaceResult& result);

}  // namespace fretwork::simulation
