// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/control.hpp>
#include <fretwork/mechanics/assembly.hpp>
#include <fretwork/mechanics/results/solution.hpp>

namespace fretwork::mechanics {

/// How the fictitious masses of rotations depend on the elements' length l.
enum class RotationalMass {
    Natural,  ///< proportional to the rotational stiffness, E I / l and G J / l: the fair baseline
    /// Larger than Natural by the factor 1 / l^2 if the mean length l of the elements, in metres, is below
    /// one: about E I / l^3 and G J / l^3, as in public implementations of [Sakai2020].
    Published
};

/// Options of dynamic relaxation.
struct RelaxationOptions {
    double relative_residual = 1e-9;  ///< residual below which the solution has converged
    /// Largest number of iterations; a structure of the size of a pattern takes thousands.
    int iterations = 200000;
    RotationalMass rotational_mass = RotationalMass::Natural;  ///< fictitious masses of rotations
    base::Control control{};                                   ///< progress counts iterations
    /// Throws InputError if a value is invalid.
    void validate() const;
};

/// Find the equilibrium under the full load by dynamic relaxation with kinetic damping: the structure is
/// released from rest, and its velocities are set to zero whenever its kinetic energy peaks. The paper
/// computes its ground truth in this way [Sakai2020]. The elements' forces are the same as in
/// follow_load_path(), so both functions find the same equilibria; relaxation costs some hundred times as
/// much. The equilibrium is stable, unless an exact symmetry keeps the structure at an unstable equilibrium
/// (a perfect column). Fictitious masses bound the stiffness of each equation from above, so that unit time
/// steps are stable. RotationalMass::Published makes the masses of rotations larger, so time steps stay
/// stable.
///
/// Prescribed displacements act in one jump from the start. No prescribed rotation may turn a node, or one
/// end of an element relative to the other, by more than pi, because it would be taken for a rotation in the
/// opposite sense. The iterations may swing a node by whole turns, so the rotation vectors are chosen at the
/// end: they continue along the elements from held nodes, with less than half a turn in each element. If the
/// forces or the stiffness do not stay finite, the solution is Termination::Diverged, at the last peak of the
/// kinetic energy, or at rest with the load factor 0 if that is not finite either. Throws InputError that
/// names such a node or an invalid option, and Stopped.
Solution relax(const Assembly& assembly, const RelaxationOptions& options = {});

}  // namespace fretwork::mechanics
