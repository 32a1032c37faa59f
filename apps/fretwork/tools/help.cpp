// SPDX-License-Identifier: GPL-3.0-or-later
// fretwork help: the help of a verb.
#include "program.hpp"

#include <cstdio>
#include <memory>
#include <string>
#include <vector>

namespace fretwork::app {
namespace {

/// The same text as that of --help.
std::string help_of(const CLI::App& program, const std::vector<std::string>& words) {
    const CLI::App* verb = &program;
    std::string usage = program.get_name();
    for (const std::string& word : words) {
        verb = &find_verb(*verb, word);
        usage += " " + word;
    }
    return verb->get_formatter()->make_help(verb, usage, CLI::AppFormatMode::Normal);
}

}  // namespace

void add_help(CLI::App& app, ExitCode&) {
    CLI::App* verb = app.add_subcommand("help", "Print the help of a verb");
    const auto words = std::make_shared<std::vector<std::string>>();
    verb->add_option("verb", *words, "A verb, and one of its own verbs if it has any (default: all verbs)")
        ->type_name("VERB");
    verb->footer("Examples:\n  fretwork help simulate\n  fretwork help case add");
    verb->callback([&app, words] { std::fputs(help_of(app, *words).c_str(), stdout); });
}

}  // namespace fretwork::app
