// SPDX-License-Identifier: GPL-3.0-or-later
#include "program.hpp"

#include <fretwork/base/error.hpp>
#include <fretwork/base/files/provenance.hpp>
#include <fretwork/base/named.hpp>
#include <fretwork/base/text.hpp>

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
constexpr Verb kVerbs[] = {
    {kLibrary, add_enumerate}, {kLibrary, add_calibrate}, {kLibrary, add_library}, {kSurface, add_tile},
    {kSurface, add_retile},    {kSurface, add_paint},     {kSurface, add_case},    {kSurface, add_simulate},
    {kSurface, add_design},    {kSurface, add_compare},   {kSurface, add_beams},   {kSurface, add_studio},
    {kMaking, add_export},     {kMaking, add_draw},       {kTools, add_solve},     {kTools, add_optimizers},
    {kTools, add_check},       {kTools, add_help},        {kTools, add_manual}};

/// What --version prints: the version in the first line, then the commit, the compiler and the libraries with
/// which the program was built.
std::string version_text() {
    std::string text = "fretwork " + base::version() + "\n";
    for (const auto& [name, value] : base::provenance()) {
        if (name == "fretwork_commit") text += "commit " + value + "\n";
        if (name == "compiler") text += "compiler " + value + "\n";
    }
    return text + "libraries " + FRETWORK_LIBRARIES;
}

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

const CLI::App& find_verb(const CLI::App& app, const std::string& wanted) {
    const auto verbs = app.get_subcommands({});
    if (verbs.empty()) throw base::InputError("'" + app.get_name() + "' has no verbs of its own");
    return *base::find_named(wanted, verbs, &CLI::App::get_name, "verb");
}

}  // namespace fretwork::app
