// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace fretwork::app {

/// Refuse outputs that would take the place of an input or of one another. Empty names are files that were
/// not asked for. Throws InputError that names the file.
void check_outputs(const std::vector<std::string>& inputs, const std::vector<std::string>& outputs);

}  // namespace fretwork::app
