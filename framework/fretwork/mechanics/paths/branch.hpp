// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace fretwork::mechanics {

/// The equilibria to follow after a loss of stability.
enum class Branch {
    Primary,  ///< equilibria of the path itself, stable or not: a flat structure stays flat
    Stable,   ///< equilibria of the stable branch, reached by a push along the critical mode
    /// Equilibria as for Stable; at a limit load, the structure snaps to a stable equilibrium of lower
    /// energy.
    Snapping
};
/// The name of a branch: "primary", "stable" or "snapping".
std::string_view branch_name(Branch branch);
/// The names of all branches.
std::vector<std::string> branch_names();
/// The branch with this name. Throws InputError that suggests the nearest name or lists all names.
Branch find_branch(std::string_view name);

}  // namespace fretwork::mechanics
