// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/design/search/case_model.hpp>
#include <fretwork/reduction/scenarios/setting.hpp>
#include <fretwork/simulation/derivatives/setting_rates.hpp>

namespace fretwork::design::detail {

/// The width and the thickness of the bars may change at most by this factor, up or down.
inline constexpr double kLargestSectionChange = 3.0;

/// Check that a section is a rectangle. Throws InputError that names the section.
void require_rectangle(const mechanics::Section& section);

/// The setting with rectangular bars of a given width in the plane and a given thickness, m. Shear areas, if
/// the setting has any, grow with the area.
reduction::Setting with_section(reduction::Setting setting, double width, double thickness);

/// The derivative of a load case's residuals along a change of the stiffness and mass of all tiles.
/// @param rates  the rates of stiffness and mass of each tile, for the present painting
Eigen::VectorXd residuals_by(
    const CaseModel& model, const TileStrains& strains, const simulation::CandidateTiles& candidates,
    const base::IndexVector<tiling::TileIndex, std::shared_ptr<const simulation::TileRate>>& rates);

}  // namespace fretwork::design::detail
