// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/control.hpp>
#include <fretwork/mechanics/assembly.hpp>
#include <fretwork/mechanics/results/solution.hpp>

namespace fretwork::mechanics {

/// How the fictitious masses of rotations grow as elements get shorter.
enum class RotationalMass {
    Natural,   ///< as their stiffness, E I / l and G J / l: the fair baseline
    Published  ///< as E I / l^3 and G J / l^3 with l in metres, as in public implementations of [Sakai2020]
};

/// Options of dynamic relaxation.
struct RelaxationOptions {
    double relative_residual = 1e-9;  ///< converged below this
    int iterations = 200000;          ///< at most; a structure of the size of patterns takes thousands
    RotationalMass rotational_mass = RotationalMass::Natural;
    base::Control control{};  ///< receives the iterations
    /// Throws InputError if a value is invalid.
    void validate() const;
};

/// Find the equilibrium under the full load by dynamic relaxation with kinetic damping: the structure is
/// released from rest, and stopped whenever its kinetic energy has a peak. The paper's ground truth is
/// computed in this way [Sakai2020]. Here the forces are those of follow_load_path(), so both find the same
/// equilibria; relaxation costs some hundred times as much. The equilibria are stable, unless an undisturbed
/// symmetry keeps the structure at an unstable one (a perfect column). Fictitious masses bound the stiffness
/// of each equation from above, so that unit time steps are stable. With RotationalMass::Published, those of
/// rotations are larger by 1 / l^2 (l: the mean length of an element, below one metre).
///
/// Prescribed displacements act from the start, in one jump. So no prescribed rotation may turn a node, or
/// one end of an element against its other, by more than pi: it would be taken for a turn the other way
/// round. Throws InputError that names such a node, or an invalid option; Stopped.
Solution relax(const Assembly& assembly, const RelaxationOptions& options = {});

}  // namespace fretwork::mechanics
