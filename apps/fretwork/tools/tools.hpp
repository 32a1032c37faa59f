// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "verbs.hpp"

namespace fretwork::app {

// The verbs about the program and its files, as those in verbs.hpp.
void add_check(CLI::App& app, ExitCode& exit_code);
void add_help(CLI::App& app, ExitCode& exit_code);
void add_manual(CLI::App& app, ExitCode& exit_code);

}  // namespace fretwork::app
