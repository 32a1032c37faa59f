// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace fretwork::base {

/// The version of this library, such as "1.0.0".
std::string version();

/// The names and values, in fixed order, that make a result reproducible: the library's version and commit,
/// the compiler, the build type, the kind of processor, and the arithmetic. Times and host names are left
/// out. Two computations with equal input and equal provenance give bitwise equal results.
std::vector<std::pair<std::string, std::string>> provenance();

/// The mark at the start of every drawing, mesh and deck that the program writes. The program overwrites an
/// existing file without asking only if the file has this mark.
inline constexpr std::string_view kMadeBy = "made by fretwork";

}  // namespace fretwork::base
