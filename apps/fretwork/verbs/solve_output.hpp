// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/internal/json_text.hpp>
#include <fretwork/mechanics/paths/branch.hpp>
#include <fretwork/mechanics/results/result_file.hpp>

#include <numbers>
#include <string>

namespace fretwork::app {

// The output of the verbs solve and simulate.

void print_solution_json(const mechanics::Result& result);

inline constexpr double kDegreesPerRadian = 180.0 / std::numbers::pi;

/// The outputs that were asked for.
struct Wanted {
    int vibration_modes = 0;
    int buckling_modes = 0;
    mechanics::Branch branch = mechanics::Branch::Primary;
};

/// The node and the degree of freedom that move most as stability is lost.
std::string component_text(const mechanics::Result& result, const mechanics::StabilityLoss& loss);

/// Print one line for each loss of stability, buckling load and natural frequency. If fewer modes of a kind
/// were found than wanted, a further line says why.
void print_losses_and_modes(const mechanics::Result& result, const Wanted& wanted);

void print_solution(const mechanics::Result& result, const Wanted& wanted);

/// Print one line about a result that is no equilibrium under the full load. If the result is from the Newton
/// solver, the line says where its path ends, why, and what helps.
void print_failure(const mechanics::Result& result, mechanics::Branch branch);

/// The estimated relative discretization error (DiscretizationError::share), or null if it is not known.
base::Json discretization_json(const mechanics::Result& result);
/// A line about the estimated difference from the solution with infinitely fine divisions.
std::string discretization_text(const mechanics::DiscretizationError& error);

}  // namespace fretwork::app
