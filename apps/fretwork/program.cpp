// SPDX-License-Identifier: GPL-3.0-or-later
#include "program.hpp"
#include "verbs/beams.hpp"
#include "verbs/draw.hpp"

#include <fretwork/base/files/provenance.hpp>

namespace fretwork::app {
namespace {

/// The verbs, in the order in which data flows.
constexpr void (*kVerbs[])(CLI::App&, ExitCode&) = {
    add_enumerate, add_calibrate, add_library,    add_tile,   add_paint, add_case,  add_simulate, add_design,
    add_compare,   add_solve,     add_optimizers, add_export, add_draw,  add_beams, add_studio};

}  // namespace

Program::Program(ExitCode& exit_code)
    : CLI::App("Flat, tileable beam patterns that bend: enumerate, calibrate, tile, simulate.", "fretwork") {
    set_version_flag("--version", base::version());
    require_subcommand(1);
    footer("See fretwork VERB --help for details and an example.");
    for (const auto add_verb : kVerbs) add_verb(*this, exit_code);
    // CLI11 calls this when all options are read, and before the verb runs.
    parse_complete_callback([this] { check_files(*this); });
}

}  // namespace fretwork::app
