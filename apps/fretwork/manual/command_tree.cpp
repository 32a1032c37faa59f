// SPDX-License-Identifier: GPL-3.0-or-later
#include "manual/command_tree.hpp"

#include <fretwork/base/text.hpp>

namespace fretwork::app {
namespace {

/// CLI11 writes the members of a choice into the kind of the value: "TEXT:{paper,stable}".
std::vector<std::string> choices_in(const std::string& type) {
    const auto begin = type.find('{');
    const auto end = type.find('}', begin == std::string::npos ? 0 : begin);
    if (begin == std::string::npos || end == std::string::npos) return {};
    return base::split(std::string_view(type).substr(begin + 1, end - begin - 1), ',');
}

OptionText option_text(const CLI::Option& option) {
    OptionText text;
    if (!option.get_lnames().empty()) text.long_name = "--" + option.get_lnames().front();
    if (!option.get_snames().empty()) text.short_name = "-" + option.get_snames().front();
    if (option.get_positional()) text.positional = option.get_name(true);
    if (option.get_type_size_max() > 0 && option.get_expected_max() > 0) {
        text.value = option.get_type_name();
        text.choices = choices_in(text.value);
    }
    text.description = option.get_description();
    text.is_required = option.get_required();
    return text;
}

}  // namespace

CommandText command_tree(const CLI::App& app, std::vector<std::string> parents) {
    CommandText text;
    text.words = std::move(parents);
    text.words.push_back(app.get_name());
    text.description = app.get_description();
    text.footer = app.get_footer();
    for (const CLI::Option* option : app.get_options()) text.options.push_back(option_text(*option));
    for (const CLI::App* verb : app.get_subcommands({}))
        text.verbs.push_back(command_tree(*verb, text.words));
    return text;
}

std::vector<const CommandText*> all_commands(const CommandText& command) {
    std::vector<const CommandText*> list{&command};
    for (const CommandText& verb : command.verbs) {
        const auto below = all_commands(verb);
        list.insert(list.end(), below.begin(), below.end());
    }
    return list;
}

}  // namespace fretwork::app
