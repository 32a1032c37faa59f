// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>

namespace fretwork::app {

/// How a command ends. Bad input and wrong usage are exceptions, and become exit code 2 in `main`.
enum class ExitCode {
    Done = 0,
    DidNotSucceed = 1,  ///< ran, but not converged, out of tolerance, nothing found
    BadInput = 2,       ///< bad input or usage
    Defect = 70,        ///< a defect of the program itself (EX_SOFTWARE of sysexits.h)
};

/// Each of these functions adds one verb to the command line: its options, its help with an example, and its
/// action. The verb writes how it ended to `exit_code` (Done if it writes nothing).
void add_enumerate(CLI::App& app, ExitCode& exit_code);
void add_calibrate(CLI::App& app, ExitCode& exit_code);
void add_library(CLI::App& app, ExitCode& exit_code);
void add_tile(CLI::App& app, ExitCode& exit_code);
void add_retile(CLI::App& app, ExitCode& exit_code);
void add_paint(CLI::App& app, ExitCode& exit_code);
void add_case(CLI::App& app, ExitCode& exit_code);
void add_simulate(CLI::App& app, ExitCode& exit_code);
void add_design(CLI::App& app, ExitCode& exit_code);
void add_compare(CLI::App& app, ExitCode& exit_code);
void add_beams(CLI::App& app, ExitCode& exit_code);
void add_solve(CLI::App& app, ExitCode& exit_code);
void add_optimizers(CLI::App& app, ExitCode& exit_code);
void add_studio(CLI::App& app, ExitCode& exit_code);
void add_export(CLI::App& app, ExitCode& exit_code);
void add_draw(CLI::App& app, ExitCode& exit_code);
void add_check(CLI::App& app, ExitCode& exit_code);
void add_help(CLI::App& app, ExitCode& exit_code);
void add_manual(CLI::App& app, ExitCode& exit_code);

}  // namespace fretwork::app
