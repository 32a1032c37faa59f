// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace fretwork::mechanics {

/// Which equilibria to follow where a path becomes unstable.
enum class Branch {
    Primary,  ///< the path itself, stable or not: a flat structure stays flat
    Stable,   ///< the stable branch, reached by a push along the critical mode
    Snapping  ///< as Stable; at a limit load the structure snaps to the stable equilibrium downhill
};
/// "primary", "stable", "snapping"
std::string_view branch_name(Branch branch);
std::vector<std::string> branch_names();
/// Throws InputError that lists the names.
Branch find_branch(std::string_view name);

}  // namespace fretwork::mechanics
