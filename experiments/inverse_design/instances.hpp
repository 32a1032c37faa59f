// SPDX-License-Identifier: GPL-3.0-or-later
// Surfaces of equal hexagons, clamped on the left and pushed at the right, and targets for them.
#pragma once

#include <fretwork/design/design.hpp>
#include <fretwork/simulation/project/project.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace fretwork::experiments {

/// `columns` x `rows` hexagons of the paper's size and setting, all painted with one pattern.
simulation::Project lattice(int columns, int rows);

/// Patterns of the paper's layout: all of them, or so many, drawn at random.
std::vector<pattern::NamedPattern> palette(const std::string& count, std::uint64_t seed);

/// How a hidden painting looks.
enum class Hidden {
    Graded,  ///< a smooth random field chooses along the palette, from soft to stiff
    Patchy,  ///< patches of three to eight tiles of one pattern each
    Random   ///< each tile by itself
};
Hidden find_hidden(const std::string& name);

struct HiddenOptions {
    Hidden kind = Hidden::Graded;
    std::vector<pattern::NamedPattern> palette;
    std::uint64_t seed = 1;
};
void paint(simulation::Project& project, const HiddenOptions& options);

/// The tip force under which a project is bent by this share of its span, with all beams.
double force_for(const simulation::Project& project, double share);
simulation::LoadCase tip_load(double force);
double span_of(const simulation::Project& project);

/// The displacements of all interface nodes under the project's first load case, with all beams.
design::Target reached_by(const simulation::Project& project);
/// The surface bent to a cylinder of this angle (rad) along x.
design::Target arc(const simulation::Project& project, double angle);

}  // namespace fretwork::experiments
