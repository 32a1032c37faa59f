// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace fretwork::base {

/// The version of Fretwork, such as "1.0.0".
std::string version();

/// Names and values that make a result reproducible, in a fixed order: Fretwork's version and commit, the
/// compiler, the build type, the kind of processor, and the arithmetic (fused multiply-add or not, the C
/// library). Times and host names are left out. Two computations with equal input, equal provenance and equal
/// versions of the libraries that Fretwork uses give bitwise equal results.
std::vector<std::pair<std::string, std::string>> provenance();

/// The mark near the start of every drawing, mesh and deck that the program writes. By this mark, the program
/// recognizes such a file and may replace it.
inline constexpr std::string_view kMadeBy = "made by fretwork";

}  // namespace fretwork::base
