// SPDX-License-Identifier: GPL-3.0-or-later
#include "manual/command_tree.hpp"

#include <fretwork/base/files/provenance.hpp>
#include <fretwork/base/text.hpp>

namespace fretwork::app {
namespace {

/// A text that groff sets as it stands: no line of it is a request.
std::string plain(const std::string& text) {
    std::string result;
    for (const char c : text) {
        const bool begins_line = result.empty() || result.back() == '\n';
        if (begins_line && (c == '.' || c == '\'')) result += "\\&";
        if (c == '\\')
            result += "\\e";
        else if (c == '-')
            result += "\\-";
        else
            result += c;
    }
    return result;
}

std::string option_entry(const OptionText& option) {
    std::string head = option.positional;
    if (head.empty()) head = option.long_name;
    if (!option.short_name.empty()) head = option.short_name + (head.empty() ? "" : ", " + head);
    std::string entry = ".TP\n.B " + plain(head);
    if (!option.value.empty()) entry += " \\fI" + plain(option.value) + "\\fR";
    return entry + "\n" + plain(option.description) + (option.is_required ? " (required)" : "") + "\n";
}

std::string section(const CommandText& command) {
    std::string text = ".SH \"" + plain(base::join(command.words, " ")) + "\"\n";
    text += plain(command.description) + "\n";
    for (const OptionText& option : command.options) text += option_entry(option);
    if (!command.footer.empty()) text += ".PP\n.nf\n" + plain(command.footer) + "\n.fi\n";
    return text;
}

}  // namespace

std::string man_page(const CommandText& program) {
    std::string text = ".\\\" SPDX-License-Identifier: GPL-3.0-or-later\n.TH FRETWORK 1 \"\" \"fretwork " +
                       base::version() + "\" \"User Commands\"\n.SH NAME\nfretwork \\- " +
                       plain(program.description) +
                       "\n.SH SYNOPSIS\n.B fretwork\n\\fIVERB\\fR [\\fIOPTIONS\\fR]\n";
    for (const CommandText* command : all_commands(program)) text += section(*command);
    return text + ".SH EXIT STATUS\n0: done. 1: ran but did not succeed. 2: bad input or usage.\n";
}

}  // namespace fretwork::app
