// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/paths/linear_range.hpp>
#include <fretwork/simulation/load_cases/load_case.hpp>
#include <fretwork/simulation/results/surface_result.hpp>
#include <fretwork/simulation/simulation_options.hpp>
#include <fretwork/simulation/surface.hpp>

#include <string>

namespace fretwork::simulation {

/// A linear solution is out of its range if its estimated error, as a share of the largest displacement,
/// exceeds this limit, or if the structure loses its stability. experiments/large_deflections measures how
/// often this verdict is right.
inline constexpr double kLinearRange = 0.05;
/// True if a linear solution with this estimate is out of its range.
[[nodiscard]] inline bool is_exceeded(const mechanics::LinearRange& range) {
    return range.loses_stability || range.error > kLinearRange;
}
/// The estimate in words.
std::string linear_range_text(const mechanics::LinearRange& range);

/// True if a linear result is out of its range: if linear_range is exceeded, or if its error and the fit
/// error of the tiles together exceed kLinearRange. False if the result has no linear_range.
bool is_out_of_range(const SurfaceResult& result);
/// The reason why a linear result is out of its range, in words, with SurfaceResult::fit_error if there is
/// one. Pre: the result has a linear_range.
std::string linear_doubt_text(const SurfaceResult& result);

/// Fill SurfaceResult::linear_range of a linear result, and SurfaceResult::fit_error if tiles have fitted
/// parameters. Throws as simulate().
void add_linear_range(const Surface& surface, const LoadCase& load_case, const SimulationOptions& options,
                      const base::Control& control, SurfaceResult& result);

/// Estimate the error of a linear solution of a surface relative to the solution for large displacements. The
/// estimate uses corotational tiles for solutions of any model. Throws as simulate().
mechanics::LinearRange surface_linear_range(const Surface& surface, const LoadCase& load_case,
                                            int threads = 0, const base::Control& control = {});

}  // namespace fretwork::simulation
