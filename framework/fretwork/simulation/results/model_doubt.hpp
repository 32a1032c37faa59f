// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/simulation/session.hpp>

#include <span>
#include <string>

namespace fretwork::simulation {

/// Above one of these three limits the error is estimated: rad, and a share of the largest displacement. No
/// result of experiments/error_warnings whose worst node is off by 5 % is below all of them.
inline constexpr double kDoubtfulRotation = 0.09;
inline constexpr double kDoubtfulChange = 0.03;
/// Linear solves from rest. A path with more of them has passed places where small differences decide.
inline constexpr int kDoubtfulIterations = 40;
/// An estimated error above this gives a warning: at the worst node, as a share of the largest displacement.
/// It is less than 5 %, since an estimate may be too small by a third.
inline constexpr double kWarnedError = 0.03;

/// The doubt about the last solution of a session, if it is a nonlinear one.
ModelDoubt model_doubt(const Session& session, const SurfaceResult& result);
/// The doubt about a solution with these deformations of its tiles.
ModelDoubt model_doubt(std::span<const TileDeformation> tiles);

/// Whether the doubt of a result is above one of the limits, so that its error has to be estimated.
bool is_doubtful(const SurfaceResult& result);

/// The warning about a converged result: its estimated error is large, or its error may be large and is not
/// known. Empty if there is no reason to warn.
std::string model_warning(const SurfaceResult& result);

}  // namespace fretwork::simulation
