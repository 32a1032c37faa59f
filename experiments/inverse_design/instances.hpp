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

/// Places in the palette from the softest pattern to the stiffest, by the trace of the bending stiffness.
std::vector<std::size_t> from_soft_to_stiff(const simulation::Project& project,
                                            const std::vector<pattern::NamedPattern>& palette);

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
/// A strip that is bent along x, with a curvature of angle / length * (1 + first cos(pi s) + second cos(2 pi
/// s)) at the share s of its length, and twisted about its middle.
struct Bend {
    double angle = 0.0;  ///< rad, of the whole length
    double first = 0.0;
    double second = 0.0;
    double twist = 0.0;  ///< rad, of the whole length
};
design::Target bent(const simulation::Project& project, const Bend& bend);

}  // namespace fretwork::experiments
