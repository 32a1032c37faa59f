// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/paths/linear_range.hpp>
#include <fretwork/simulation/load_cases/load_case.hpp>
#include <fretwork/simulation/results/surface_result.hpp>
#include <fretwork/simulation/simulation_options.hpp>
#include <fretwork/simulation/surface.hpp>

#include <string>

namespace fretwork::simulation {

/// Beyond this error, or where stability is lost, a linear solution is reported as out of its range. How
/// often that is right: experiments/large_deflections.
inline constexpr double kLinearRange = 0.05;
[[nodiscard]] inline bool is_exceeded(const mechanics::LinearRange& range) {
    return range.loses_stability || range.error > kLinearRange;
}
/// In words, for people.
std::string linear_range_text(const mechanics::LinearRange& range);

/// Whether a linear result is beyond its range, by its displacements or, together with these, by what the fit
/// of its tiles is off.
bool is_out_of_range(const SurfaceResult& result);
/// In words, for people: why it is, with `SurfaceResult::fit_error`.
std::string linear_doubt_text(const SurfaceResult& result);

/// Adds linear_range, and fit_error where tiles have fitted parameters, to a linear result. Throws as
/// simulate().
void add_linear_range(const Surface& surface, const LoadCase& load_case, const SimulationOptions& options,
                      const base::Control& control, SurfaceResult& result);

/// How far a linear solution of the surface is from that for large displacements: of its corotational tiles,
/// whatever model it was solved with. Throws as simulate().
mechanics::LinearRange surface_linear_range(const Surface& surface, const LoadCase& load_case,
                                            int threads = 0, const base::Control& control = {});

}  // namespace fretwork::simulation
