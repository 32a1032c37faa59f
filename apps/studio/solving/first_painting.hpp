// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/control.hpp>
#include <fretwork/simulation/project/project.hpp>

#include <string>

namespace fretwork::studio {

/// Paint a project that has just been tiled with one pattern that can be made: its bars do not overlap, and
/// its gaps and openings are not below the clearance of fabrication::FactsOptions, on these tiles and with
/// bars of this width. It tries the 200 patterns of the layout with the fewest bars, by number of bars and
/// then by name, and takes the first that can be made: the least to cut, and the widest gaps. Returns a
/// remark for people; empty if there is none. If no pattern can be made the tiles stay as they are.
std::string paint_to_be_made(simulation::Project& project, const base::Control& control);

}  // namespace fretwork::studio
