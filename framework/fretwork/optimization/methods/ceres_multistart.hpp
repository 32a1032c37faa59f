// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/optimization/methods/multistart.hpp>

#include <memory>

namespace fretwork::optimization {

/// Ceres' Levenberg-Marquardt with bounds on the problem's generalized Gauss-Newton model.
///
/// Ceres sees the residuals [L^-1 g; sqrt(2 E - |L^-1 g|^2)] with the Jacobian [L^T; 0], where E, g and
/// L L^T are value, gradient and curvature: their cost is E, their gradient g and their normal matrix L L^T,
/// so that every point which Ceres accepts, and every one where it stops, is one of E itself. The root is
/// real wherever the curvature is at least 2 J^T J of residuals whose squared norm is E. Half the squared
/// norm of L^-1 g is what an undamped step gains by the model: a callback ends the stage once that is less
/// than its tolerance.
std::unique_ptr<Optimizer> make_ceres_multistart(const MultistartOptions& options);

}  // namespace fretwork::optimization
