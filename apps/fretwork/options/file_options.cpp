// SPDX-License-Identifier: GPL-3.0-or-later
#include "options/file_options.hpp"
#include "program.hpp"

#include <fretwork/base/files/provenance.hpp>

namespace fretwork::app {
namespace {

Program& program_of(CLI::App& verb) {
    CLI::App* root = &verb;
    while (root->get_parent() != nullptr) root = root->get_parent();
    return dynamic_cast<Program&>(*root);
}

}  // namespace

bool says_who_made_it(std::string_view start) {
    return start.find(base::kMadeBy) != std::string_view::npos;
}

void declare_files(CLI::App& verb, std::initializer_list<DeclaredFile> files) {
    Program& program = program_of(verb);
    for (const DeclaredFile& file : files) {
        CLI::Option* option = verb.get_option(file.option);
        if (file.role != FileRole::Input)
            option->type_name(file.role == FileRole::OutputFolder ? "FOLDER" : "FILE");
        program.declare({option, file.role, file.kind});
    }
}

}  // namespace fretwork::app
