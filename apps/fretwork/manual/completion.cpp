// SPDX-License-Identifier: GPL-3.0-or-later
#include "manual/command_tree.hpp"

#include <fretwork/base/text.hpp>

namespace fretwork::app {
namespace {

constexpr const char* kLicence = "# SPDX-License-Identifier: GPL-3.0-or-later\n";

/// The words that may come next: verbs and options.
std::string next_words(const CommandText& command) {
    std::vector<std::string> words;
    for (const CommandText& verb : command.verbs) words.push_back(verb.words.back());
    for (const OptionText& option : command.options)
        if (!option.long_name.empty()) words.push_back(option.long_name);
    return base::join(words, " ");
}

/// The branches of a shell's `case` that give, for each command, the words that may come next.
std::string word_branches(const CommandText& program) {
    std::string text;
    for (const CommandText* command : all_commands(program))
        text += "    '" + base::join(command->words, " ") + "') next='" + next_words(*command) + "' ;;\n";
    return text;
}

std::string value_branches(const CommandText& program) {
    std::string text;
    for (const CommandText* command : all_commands(program))
        for (const OptionText& option : command->options)
            if (!option.choices.empty() && !option.long_name.empty())
                text += "    '" + base::join(command->words, " ") + " " + option.long_name + "') values='" +
                        base::join(option.choices, " ") + "' ;;\n";
    return text + "    *' --'*) values='' ;;\n";
}

/// All verbs by their words, for finding the command that is being typed.
std::string command_pattern(const CommandText& program) {
    std::vector<std::string> quoted;
    for (const CommandText* command : all_commands(program))
        quoted.push_back("'" + base::join(command->words, " ") + "'");
    return base::join(quoted, "|");
}

std::string quoted_for_fish(const std::string& text) {
    std::string result = "'";
    for (const char c : text.substr(0, text.find('\n'))) {
        if (c == '\'' || c == '\\') result += '\\';
        result += c;
    }
    return result + "'";
}

/// True in fish where the words typed so far are those of the command, and of none below it.
std::string fish_condition(const CommandText& command) {
    std::string test = "true";
    for (std::size_t i = 1; i < command.words.size(); ++i)
        test += "; and __fish_seen_subcommand_from " + command.words[i];
    std::vector<std::string> below;
    for (const CommandText& verb : command.verbs) below.push_back(verb.words.back());
    if (!below.empty()) test += "; and not __fish_seen_subcommand_from " + base::join(below, " ");
    return test;
}

}  // namespace

std::string bash_completion(const CommandText& program) {
    return std::string(kLicence) +
           "_fretwork() {\n"
           "  local command=fretwork next='' values='' word\n"
           "  for word in \"${COMP_WORDS[@]:1:COMP_CWORD-1}\"; do\n"
           "    case \"$command $word\" in\n    " +
           command_pattern(program) +
           ") command+=\" $word\" ;;\n    esac\n  done\n"
           "  case \"$command\" in\n" +
           word_branches(program) + "  esac\n  case \"$command ${COMP_WORDS[COMP_CWORD-1]}\" in\n" +
           value_branches(program) +
           "  esac\n"
           "  if [[ -n $values ]]; then next=$values\n"
           "  elif [[ ${COMP_WORDS[COMP_CWORD-1]} == --* && ${COMP_WORDS[COMP_CWORD]} != -* ]]; then "
           "next=''\n"
           "  fi\n"
           "  COMPREPLY=($(compgen -W \"$next\" -- \"${COMP_WORDS[COMP_CWORD]}\"))\n"
           "}\n"
           "complete -o default -F _fretwork fretwork\n";
}

std::string zsh_completion(const CommandText& program) {
    return "#compdef fretwork\n" + std::string(kLicence) +
           "_fretwork() {\n"
           "  local command=fretwork next='' values='' word\n"
           "  for word in \"${(@)words[2,CURRENT-1]}\"; do\n"
           "    case \"$command $word\" in\n    " +
           command_pattern(program) +
           ") command+=\" $word\" ;;\n    esac\n  done\n"
           "  case \"$command\" in\n" +
           word_branches(program) + "  esac\n  case \"$command ${words[CURRENT-1]}\" in\n" +
           value_branches(program) +
           "  esac\n"
           "  if [[ -n $values ]]; then compadd -- ${=values}\n"
           "  elif [[ ${words[CURRENT-1]} == --* && ${words[CURRENT]} != -* ]]; then _files\n"
           "  else compadd -- ${=next}; _files\n  fi\n"
           "}\n"
           "_fretwork \"$@\"\n";
}

std::string fish_completion(const CommandText& program) {
    std::string text = kLicence;
    for (const CommandText* command : all_commands(program)) {
        const std::string start = "complete -c fretwork -n '" + fish_condition(*command) + "'";
        for (const CommandText& verb : command->verbs)
            text += start + " -f -a " + verb.words.back() + " -d " + quoted_for_fish(verb.description) + "\n";
        for (const OptionText& option : command->options) {
            if (option.long_name.empty()) continue;
            text += start + " -l " + option.long_name.substr(2);
            if (!option.choices.empty()) text += " -x -a '" + base::join(option.choices, " ") + "'";
            if (option.choices.empty() && !option.value.empty()) text += " -r";
            text += " -d " + quoted_for_fish(option.description) + "\n";
        }
    }
    return text;
}

}  // namespace fretwork::app
