// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/paths/linear_range.hpp>
#include <fretwork/simulation/load_cases/load_case.hpp>
#include <fretwork/simulation/results/surface_result.hpp>
#include <fretwork/simulation/simulation_options.hpp>
#include <fretwork/simulation/surface.hpp>

#include <string>

namespace fretwork::simulation {

/// Beyond this error, or after a loss of stability, a linear solution is reported as out of its range.
/// experiments/large_deflections measures how often such a report is right.
inline constexpr double kLinearRange = 0.05;
/// True if a linear solution is out of its range.
[[nodiscard]] inline bool is_exceeded(const mechanics::LinearRange& range) {
    return range.loses_stability || range.error > kLinearRange;
}
/// The range in words, for people.
std::string linear_range_text(const mechanics::LinearRange& range);

/// True if a linear result is out of its range: by the error of its displacements, or by this error together
/// with the fit error of its tiles.
bool is_out_of_range(const SurfaceResult& result);
/// The reason in words, for people, with `SurfaceResult::fit_error`.
std::string linear_doubt_text(const SurfaceResult& result);

/// Add linear_range to a linear result, and fit_error if tiles have fitted parameters. Throws as simulate().
void add_linear_range(const Surface& surface, const LoadCase& load_case, const SimulationOptions& options,
                      const base::Control& control, SurfaceResult& result);

/// The estimated error of a linear solution of the surface relative to large displacements. The estimate uses
/// corotational tiles, whatever model the solution has. Throws as simulate().
mechanics::LinearRange surface_linear_range(const Surface& surface, const LoadCase& load_case,
                                            int threads = 0, const base::Control& control = {});

}  // namespace fretwork::simulation
