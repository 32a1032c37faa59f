// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/paths/linear_range.hpp>
#include <fretwork/simulation/load_cases/load_case.hpp>
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

/// How far a linear solution of the surface is from that for large displacements: of its corotational tiles,
/// whatever model it was solved with. Throws as simulate().
mechanics::LinearRange surface_linear_range(const Surface& surface, const LoadCase& load_case,
                                            int threads = 0, const base::Control& control = {});

}  // namespace fretwork::simulation
