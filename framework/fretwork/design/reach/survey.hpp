// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/design/search/search.hpp>

namespace fretwork::design::detail {

/// Compare the displacements of solved uniform paintings with the wanted displacements, and collect their
/// curvatures. Fills nothing_moves and Gamut::reached of the report and, unless nothing moves,
/// wanted_of_softest and wanted_of_stiffest. Pre: `uniform` is not empty.
void survey(const Trials& trials, const std::vector<Solved>& uniform, DesignReport& report);

/// Add the curvatures of uniform paintings to Gamut::reached.
void add_reached_curvatures(const Trials& trials, const std::vector<Solved>& uniform, Gamut& gamut);

/// The largest displacement of the softest uniform painting under ten times its loads, as a share of the
/// largest wanted displacement. None if wanted_of_softest is at most kLoadTooSmall, if there are no loads, if
/// their factor or the prescribed values are free, or if an equilibrium is not found. Throws Stopped.
std::optional<double> reach_of_ten_loads(Trials& trials, const std::vector<Solved>& uniform,
                                         const DesignReport& report, const base::Control& control);

/// Fill Gamut::wanted and Gamut::designed from the shapes of a painting.
void add_wanted_curvatures(const tiling::Tessellation& tessellation, const std::vector<CaseShape>& shapes,
                           Gamut& gamut);

}  // namespace fretwork::design::detail
