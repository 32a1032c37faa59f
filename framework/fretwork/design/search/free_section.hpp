// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/design/search/case_model.hpp>
#include <fretwork/reduction/scenarios/setting.hpp>
#include <fretwork/simulation/derivatives/setting_rates.hpp>

namespace fretwork::design::detail {

/// The bars stay between a third and three times their width and thickness.
inline constexpr double kLargestSectionChange = 3.0;

/// Throws InputError that names the section unless it is that of a rectangle, from which width and thickness
/// can be taken.
void require_rectangle(const mechanics::Section& section);

/// The setting with rectangular bars of this width in the plane and this thickness (m); shear areas follow.
reduction::Setting with_section(reduction::Setting setting, double width, double thickness);

/// The change of a case's residuals by a change of all tiles' stiffness and mass.
/// @param rates  of the painting
Eigen::VectorXd residuals_by(
    const CaseModel& model, const TileStrains& strains, const simulation::CandidateTiles& candidates,
    const base::IndexVector<tiling::TileIndex, std::shared_ptr<const simulation::TileRate>>& rates);

}  // namespace fretwork::design::detail
