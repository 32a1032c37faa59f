// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace fretwork::base {

/// The version of this library, such as "0.1.0".
std::string version();

/// What a result should carry so that it can be made again: names and values, in a fixed order, without times
/// and hosts. Holds the library's version and commit, the compiler, the build type, the kind of machine, and
/// the arithmetic: results have the same bits where all of these are the same.
std::vector<std::pair<std::string, std::string>> provenance();

/// What drawings, meshes and decks say of themselves in their first lines. The program replaces a file
/// without asking only if it has made it.
inline constexpr std::string_view kMadeBy = "made by fretwork";

}  // namespace fretwork::base
