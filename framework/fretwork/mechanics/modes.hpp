// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/control.hpp>
#include <fretwork/mechanics/assembly.hpp>

#include <cstddef>
#include <string>
#include <vector>

namespace fretwork::mechanics {

/// A mode of vibration about the rest position, or a mode of buckling.
struct Mode {
    double value = 0.0;  ///< frequency in Hz for vibration, load factor for buckling
    /// The shape of the mode, one row for each reported node. The mode is scaled so that the largest
    /// component of the displacements of all nodes is 1. A mode without displacements is scaled so that the
    /// largest component of its rotations is 1.
    NodeValues shape;
    NodeValues inner_shape{};  ///< rows of the assembly's other nodes, as in Solution::inner_displacements
};

/// The largest number of modes that can be wanted.
inline constexpr int kMostModes = 1000;

/// Options of the search for modes.
struct ModeOptions {
    base::Control control{};  ///< progress and stop
};

/// The modes of the lowest natural frequencies, ascending, with consistent masses. Prescribed components are
/// held. The number of modes is at most the number of free components with mass. Throws InputError if `count`
/// is below one or above kMostModes, if no element has mass, or if the mass of an element is not known;
/// NumericalError as LinearSolver, or if the search does not settle; Stopped.
std::vector<Mode> vibration_modes(const Assembly& assembly, int count, const ModeOptions& options = {});

/// The modes of linearized buckling, ascending in their load factor. If the loads and prescribed
/// displacements are multiplied by this factor, the stiffness plus the geometric stiffness of the linear
/// solution becomes singular. Only positive factors up to about 1e8 times the smallest absolute factor are
/// returned, so there may be fewer modes than `count`; if nothing strains the structure, there are none.
/// Moments are treated as semi-tangential moments, which have a potential: the load factors belong to the
/// symmetric part of the stiffness. Throws as vibration_modes(), except that no mass is needed.
std::vector<Mode> buckling_modes(const Assembly& assembly, int count, const ModeOptions& options = {});

/// A message that says why fewer modes of vibration were found than wanted. Empty if all were found.
std::string missing_vibration_modes_text(std::ptrdiff_t found, int wanted);
/// A message that says why fewer modes of buckling were found than wanted. Empty if all were found.
std::string missing_buckling_modes_text(std::ptrdiff_t found, int wanted);

}  // namespace fretwork::mechanics
