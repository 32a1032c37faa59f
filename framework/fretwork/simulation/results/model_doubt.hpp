// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/simulation/session.hpp>

#include <span>
#include <string>
#include <vector>

namespace fretwork::simulation {

/// The limit of ModelDoubt::tile_rotation, rad. A result is doubtful, and its error is estimated, if one of
/// three limits is exceeded (kDoubtfulRotation, kDoubtfulChange or kDoubtfulIterations), or if a loss of
/// stability is listed (Solution::stability_losses; a converged path along the primary branch lists none). In
/// experiments/error_warnings, this is so for every result with an error of more than 5 % at its worst node.
inline constexpr double kDoubtfulRotation = 0.09;
/// The limit of ModelDoubt::change, the distance between a corotational solution and a mixed solution, as a
/// share of the largest displacement.
inline constexpr double kDoubtfulChange = 0.03;
/// The limit of Solution::iterations, the number of linear solves of a solution, load step or load stage. A
/// path with more linear solves may have passed states where small differences decide between equilibria.
inline constexpr int kDoubtfulIterations = 40;
/// The limit of warned_error() for estimates with all beams of all tiles.
inline constexpr double kWarnedError = 0.05;
/// The limit of warned_error() for estimates with all beams of only some tiles. It is lower because these
/// estimates may be too small by a third.
inline constexpr double kWarnedEstimate = 0.03;

/// The indicators of the last solution of a session, which must be nonlinear. ModelDoubt::change is 0 if the
/// solution has not converged. Throws InputError as Session::tile_deformations(), or as compare(); Stopped.
ModelDoubt model_doubt(const Session& session, const SurfaceResult& result,
                       const base::Control& control = {});
/// The indicators of a solution with these deformations of its tiles.
ModelDoubt model_doubt(std::span<const TileDeformation> tiles);

/// True if an indicator of a result is above its limit, or if a loss of stability is listed: the error then
/// has to be estimated. False if the result has no model_doubt.
bool is_doubtful(const SurfaceResult& result);

/// The limit of the estimated error at the worst node, as a share of the largest displacement, for a warning:
/// kWarnedError or kWarnedEstimate.
double warned_error(const ModelError& error);
/// The warning about a result that is no equilibrium under the whole load, or an unstable one. Empty if there
/// is no reason to warn.
std::string path_warning(const SurfaceResult& result);
/// The warning about a converged result with an estimated error that is large, or with an unknown error that
/// may be large. Empty if there is no reason to warn.
std::string model_warning(const SurfaceResult& result);
/// All warnings about a result, each in one line: path_warning(), linear_doubt_text() if is_out_of_range(),
/// and model_warning(). Empty if there is no reason to warn.
std::vector<std::string> result_warnings(const SurfaceResult& result);

}  // namespace fretwork::simulation
