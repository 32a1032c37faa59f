// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace fretwork::studio {

/// An error for people who see a surface and no files: places in messages and files become words ("load
/// case 1, support 2"), and what the solvers say becomes what can be done.
std::string in_words(const std::string& error);

}  // namespace fretwork::studio
