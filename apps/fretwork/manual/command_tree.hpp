// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

namespace fretwork::app {

/// An option as --help describes it.
struct OptionText {
    std::string long_name;             ///< "--out"; empty if it has none
    std::string short_name;            ///< "-h"; empty if it has none
    std::string positional;            ///< the name of a positional option, else empty
    std::string value;                 ///< the kind of its value, such as "FILE"; empty for a flag
    std::vector<std::string> choices;  ///< the values that it takes, if they are few
    std::string description;
    bool is_required = false;
};

/// A verb with its options and its own verbs: all that --help says of it.
struct CommandText {
    std::vector<std::string> words;  ///< "fretwork", "case", "add"
    std::string description;
    std::string footer;
    std::vector<OptionText> options;
    std::vector<CommandText> verbs;
};

/// A command with its options and its verbs, at all levels.
/// @param parents  the words before the name of `app`
CommandText command_tree(const CLI::App& app, std::vector<std::string> parents = {});

/// A command and all verbs below it, each before its own verbs. The pointers lead into `command`.
std::vector<const CommandText*> all_commands(const CommandText& command);

/// The program's manual page in section 1, for man and groff.
std::string man_page(const CommandText& program);

// The files with which a shell completes verbs, options, and values from a short list (OptionText::choices).
// The shell completes all other words as names of files.
std::string bash_completion(const CommandText& program);
std::string zsh_completion(const CommandText& program);
std::string fish_completion(const CommandText& program);

}  // namespace fretwork::app
