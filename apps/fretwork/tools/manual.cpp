// SPDX-License-Identifier: GPL-3.0-or-later
// fretwork manual: the manual page, and completion for shells.
#include "manual/command_tree.hpp"
#include "verbs.hpp"

#include <cstdio>
#include <utility>
#include <vector>

namespace fretwork::app {
namespace {

struct ManualForm {
    const char* option;
    const char* description;
    std::string (*text)(const CommandText& program);
};

constexpr ManualForm kManualForms[] = {
    {"--man", "The manual page (section 1)", man_page},
    {"--bash", "Completion for bash", bash_completion},
    {"--zsh", "Completion for zsh", zsh_completion},
    {"--fish", "Completion for fish", fish_completion},
};

}  // namespace

void add_manual(CLI::App& app, ExitCode&) {
    CLI::App* verb = app.add_subcommand("manual", "Print the manual page, or completion for a shell");
    std::vector<std::pair<const CLI::Option*, const ManualForm*>> forms;
    for (const ManualForm& form : kManualForms)
        forms.emplace_back(verb->add_flag(form.option, form.description), &form);
    verb->require_option(1);
    verb->footer("Examples:\n  fretwork manual --man > fretwork.1\n  source <(fretwork manual --bash)");
    verb->callback([&app, forms] {
        for (const auto& [flag, form] : forms)
            if (flag->count() > 0) std::fputs(form->text(command_tree(app)).c_str(), stdout);
    });
}

}  // namespace fretwork::app
