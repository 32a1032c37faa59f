// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/control.hpp>
#include <fretwork/mechanics/assembly.hpp>

#include <cstddef>
#include <string>
#include <vector>

namespace fretwork::mechanics {

/// A way in which a structure vibrates about its rest position, or buckles.
struct Mode {
    double value = 0.0;  ///< vibration: frequency in Hz; buckling: load factor
    /// One row for each reported node. The largest displacement, here or inside, is 1; of a mode that only
    /// turns, the largest rotation.
    NodeValues shape;
    NodeValues inner_shape{};  ///< the assembly's other nodes, as Solution::inner_displacements
};

/// Options of the search for modes.
struct ModeOptions {
    base::Control control{};
};

/// The modes of the lowest natural frequencies, ascending: consistent masses, prescribed components held. At
/// most as many as there are free components with mass, and none if all of them are held. Throws InputError
/// if no element has mass, NumericalError and Stopped as LinearSolver.
std::vector<Mode> vibration_modes(const Assembly& assembly, int count, const ModeOptions& options = {});

/// The modes of linearized buckling, ascending in the factor on the loads at which the stiffness, with the
/// geometric stiffness of the linear solution, becomes singular; positive factors only, so there may be fewer
/// than wanted, or none, as where nothing is loaded. Moments count as if they had a potential (as
/// semi-tangential ones): of moments of fixed direction the factors are those of the stiffness' symmetric
/// part. Throws as vibration_modes.
std::vector<Mode> buckling_modes(const Assembly& assembly, int count, const ModeOptions& options = {});

/// Why fewer modes were found than wanted, for people; empty if all were found.
std::string missing_vibration_modes_text(std::ptrdiff_t found, int wanted);
std::string missing_buckling_modes_text(std::ptrdiff_t found, int wanted);

}  // namespace fretwork::mechanics
