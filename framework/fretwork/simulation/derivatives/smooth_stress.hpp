// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/simulation/session.hpp>

#include <functional>

namespace fretwork::simulation {

/// Options of the smooth largest stress.
struct SmoothStressOptions {
    /// Exponent p, at least 2; a larger exponent brings the value nearer to the largest stress.
    double exponent = 32.0;
    /// Number of threads; 0: one for each processor. The result is bitwise the same for every number of
    /// threads.
    int threads = 0;
    /// Throws InputError if a value is invalid.
    void validate() const;
};

/// A smooth approximation of the largest von Mises stress v over the beams of a surface: the p-norm over the
/// m points of mechanics::SectionPoints at both ends of all beams,
///
///     value = (sum of v^p)^(1/p),     largest <= value <= largest m^(1/p).
struct SmoothStress {
    double value = 0.0;    ///< smooth stress, Pa
    double largest = 0.0;  ///< largest von Mises stress, Pa
    /// The derivatives of `value` with respect to displacements and rotation vectors, one row for each node
    /// of the result.
    mechanics::NodeValues gradient;
};

/// The smooth stress in a solution since the session's last edit. Value and gradient are exact for condensed
/// and corotational tiles, because their beams depend linearly on the strains of the tile. Throws InputError
/// for other tiles, because their stresses or derivatives of stresses are not known, if an option is invalid,
/// and as Session::require_since_edit().
SmoothStress smooth_stress(const Session& session, const mechanics::Solution& solution,
                           const SmoothStressOptions& options = {});

/// A curve of settings.
struct SettingCurve {
    /// The curve, evaluated from -2 `step` to 2 `step`.
    std::function<reduction::Setting(double)> setting;
    double step = 1e-3;  ///< step of the curve's parameter for the differences
};

/// The derivative of the smooth stress along a curve of settings at fixed nodes, at 0 of the curve's
/// parameter, by central differences of fourth order. The total derivative is the sum of this one and
/// derivative_along(). Throws InputError if an option is invalid, if the stress of a beam is not known, and
/// as beam_state() of a result.
double smooth_stress_along(const Session& session, const SurfaceResult& result, const SettingCurve& curve,
                           const SmoothStressOptions& options = {});

}  // namespace fretwork::simulation
