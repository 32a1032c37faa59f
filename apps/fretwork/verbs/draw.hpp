// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "program.hpp"

namespace fretwork::app {

/// Adds the verb `draw`.
void add_draw(CLI::App& app, ExitCode& exit_code);

}  // namespace fretwork::app
