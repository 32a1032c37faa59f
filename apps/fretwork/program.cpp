// SPDX-License-Identifier: GPL-3.0-or-later
#include "program.hpp"
#include "tools/tools.hpp"
#include "tools/version.hpp"
#include "verbs/beams.hpp"
#include "verbs/draw.hpp"

namespace fretwork::app {
namespace {

struct Verb {
    const char* group;  ///< the heading above it in the help
    void (*add)(CLI::App&, ExitCode&);
};

constexpr const char* kLibrary = "Pattern library";
constexpr const char* kSurface = "Surface";
constexpr const char* kMaking = "Making and output";
constexpr const char* kTools = "Tools";

/// The verbs, in the order in which data flows.
constexpr Verb kVerbs[] = {{kLibrary, add_enumerate}, {kLibrary, add_calibrate}, {kLibrary, add_library},
                           {kSurface, add_tile},      {kSurface, add_paint},     {kSurface, add_case},
                           {kSurface, add_simulate},  {kSurface, add_design},    {kSurface, add_compare},
                           {kSurface, add_beams},     {kSurface, add_studio},    {kMaking, add_export},
                           {kMaking, add_draw},       {kTools, add_solve},       {kTools, add_optimizers},
                           {kTools, add_check},       {kTools, add_help},        {kTools, add_manual}};

}  // namespace

Program::Program(ExitCode& exit_code)
    : CLI::App("Flat, tileable beam patterns that bend: enumerate, calibrate, tile, simulate.", "fretwork") {
    set_version_flag("--version", version_text());
    require_subcommand(1);
    footer("See fretwork help VERB for details and an example.");
    for (const Verb& verb : kVerbs) {
        verb.add(*this, exit_code);
        get_subcommands({}).back()->group(verb.group);
    }
    // CLI11 calls this when all options are read, and before the verb runs.
    parse_complete_callback([this] { check_files(*this); });
}

}  // namespace fretwork::app
