// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace fretwork::app {

/// What --version prints: the version in the first line, then the commit, the compiler and the libraries with
/// which the program was built.
std::string version_text();

}  // namespace fretwork::app
