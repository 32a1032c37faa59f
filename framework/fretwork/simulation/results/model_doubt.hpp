// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/simulation/session.hpp>

#include <span>
#include <string>

namespace fretwork::simulation {

/// Above one of these the error is estimated: rad, and a share of the largest displacement. No result of
/// experiments/error_warnings that is off by 5 % at its worst node is below all three.
inline constexpr double kDoubtfulRotation = 0.09;
inline constexpr double kDoubtfulChange = 0.03;
/// Linear solves from rest, above which a path has passed places where small differences decide.
inline constexpr int kDoubtfulIterations = 40;
/// Estimated errors above this are warned of, as a share of the largest displacement, at the worst node: less
/// than 5 %, since an estimate may be too small by a third.
inline constexpr double kWarnedError = 0.03;

/// The doubt about the last solution of a session, if it is a nonlinear one.
ModelDoubt model_doubt(const Session& session, const SurfaceResult& result);
/// The same of tiles that are deformed so far.
ModelDoubt model_doubt(std::span<const TileDeformation> tiles);

/// Whether the error of a result with a doubt may be large, and has to be estimated.
bool is_doubtful(const SurfaceResult& result);

/// What a user has to be told of a converged result: that its error is estimated to be large, or may be, and
/// is not known. Empty: nothing.
std::string model_warning(const SurfaceResult& result);

}  // namespace fretwork::simulation
