// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace fretwork::base {

/// The version of this library, such as "0.1.0".
std::string version();

/// The names and values that a result carries so that it can be reproduced: the library's version and commit,
/// the compiler, the build type, the kind of machine, and the arithmetic. The order of the names is fixed,
/// and times and host names are left out. Two computations with equal input and equal provenance give results
/// with the same bits.
std::vector<std::pair<std::string, std::string>> provenance();

/// The first line of every drawing, mesh and deck that the program writes. The program replaces an existing
/// file without asking only if that file carries this line.
inline constexpr std::string_view kMadeBy = "made by fretwork";

}  // namespace fretwork::base
