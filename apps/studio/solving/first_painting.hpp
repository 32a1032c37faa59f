// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/control.hpp>
#include <fretwork/simulation/project/project.hpp>

#include <string>

namespace fretwork::studio {

/// Paint a project that has just been tiled with one pattern that can be made: its bars do not overlap, and
/// its gaps and openings are as wide as facts ask for, on these tiles and with bars of this width. Among all
/// such patterns of the layout it takes the one with the fewest bars, then the first by name: the least to
/// cut, and the widest gaps. Returns a remark for people; empty if there is none. If no pattern can be made
/// the tiles stay as they are.
std::string paint_to_be_made(simulation::Project& project, const base::Control& control);

}  // namespace fretwork::studio
