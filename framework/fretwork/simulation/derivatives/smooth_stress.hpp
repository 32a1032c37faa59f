// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/simulation/session.hpp>

#include <functional>

namespace fretwork::simulation {

struct SmoothStressOptions {
    double exponent = 32.0;  ///< p, at least 2: the larger, the nearer to the largest stress
    int threads = 0;         ///< 0: all there are. They change no bit.
    /// Throws InputError.
    void validate() const;
};

/// A smooth stand-in for the largest von Mises stress v over the beams of a surface: the p-norm over the m
/// points of mechanics::SectionPoints at both ends of all beams,
///
///     value = (sum of v^p)^(1/p),     largest <= value <= largest m^(1/p).
struct SmoothStress {
    double value = 0.0;    ///< Pa
    double largest = 0.0;  ///< Pa
    /// dvalue by displacements and rotation vectors, a row for each node of the result.
    mechanics::NodeValues gradient;
};

/// The smooth stress in a solution that the session gave since its last edit. Exact where beams answer
/// linearly to their tile's strains: of condensed and corotational tiles. Throws InputError for others, whose
/// stresses or their derivatives are not known.
SmoothStress smooth_stress(const Session& session, const mechanics::Solution& solution,
                           const SmoothStressOptions& options = {});

/// A curve of settings.
struct SettingCurve {
    std::function<reduction::Setting(double)> setting;  ///< evaluated from -2 `step` to 2 `step`
    double step = 1e-3;                                 ///< of its parameter
};

/// How the smooth stress changes along a curve of settings while no node moves, at 0 of its parameter: by
/// central differences of fourth order. Added to derivative_along(), it is the whole derivative.
double smooth_stress_along(const Session& session, const SurfaceResult& result, const SettingCurve& curve,
                           const SmoothStressOptions& options = {});

}  // namespace fretwork::simulation
