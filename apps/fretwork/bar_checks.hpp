// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/library/library.hpp>
#include <fretwork/simulation/project/project.hpp>

#include <CLI/CLI.hpp>

#include <string>

namespace fretwork::app {

/// The option --clearance of verbs that paint.
void add_clearance_option(CLI::App& verb, std::string& clearance);
/// One line on standard error if bars overlap, or come nearer than the clearance (a length; empty: 0).
void warn_of_close_bars(const simulation::Project& project, const library::Library* library,
                        const std::string& clearance);

/// The strength that --strength gives as "40MPa" or "4e7", in Pa. Throws InputError.
double parse_strength(const std::string& text);

}  // namespace fretwork::app
