// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/design/search/search.hpp>

namespace fretwork::design::detail {

/// What solved uniform paintings say of the load: how far they are displaced beside what is wanted, and which
/// curvatures they take. Fills the report's wanted_of_softest, wanted_of_stiffest and gamut.
void survey(const Trials& trials, const std::vector<Solved>& uniform, DesignReport& report);

/// Add the curvatures of uniform paintings to those that are reached.
void add_reached_curvatures(const Trials& trials, const std::vector<Solved>& uniform, Gamut& gamut);

/// The displacement of the softest one under ten times its loads, as a share of what is wanted. None if the
/// loads do not have to be so large, there are none, or there is no equilibrium. Throws Stopped.
std::optional<double> reach_of_ten_loads(Trials& trials, const std::vector<Solved>& uniform,
                                         const DesignReport& report, const base::Control& control);

/// The curvatures that the goals want of whole tiles, and those of the painting there.
void add_wanted_curvatures(const tiling::Tessellation& tessellation, const std::vector<CaseShape>& shapes,
                           Gamut& gamut);

}  // namespace fretwork::design::detail
