// SPDX-License-Identifier: GPL-3.0-or-later
#include "options/file_options.hpp"
#include "program.hpp"

#include <fretwork/base/error.hpp>
#include <fretwork/base/files/file.hpp>
#include <fretwork/base/files/provenance.hpp>
#include <fretwork/mechanics/frame/frame_file.hpp>

#include <algorithm>

namespace fretwork::app {
namespace {

Program& program_of(CLI::App& verb) {
    CLI::App* root = &verb;
    while (root->get_parent() != nullptr) root = root->get_parent();
    return dynamic_cast<Program&>(*root);
}

/// How the tables begin that this program makes: those of enumerate, optimizers, export and library export.
constexpr std::string_view kTableStarts[] = {
    "edges,patterns,",  "id,edges,symmetry,", "problem,best_value,", "problem,optimizer,",
    "problem,kind,",    "problem,variable,",  "node,x_m,",           "pattern_id,",
    "id,layout,edges,", "name,position,",     "beam,tile,"};

}  // namespace

bool says_who_made_it(std::string_view start) {
    return start.find(base::kMadeBy) != std::string_view::npos;
}

bool is_our_table(std::string_view start) {
    return std::ranges::any_of(kTableStarts,
                               [&](std::string_view header) { return start.starts_with(header); });
}

bool is_frame_as_written(const std::filesystem::path& path) {
    try {
        return mechanics::frame_text(mechanics::read_frame(path)) == base::read_text_file(path);
    } catch (const base::InputError&) {
        return false;  // no frame at all
    }
}

bool is_list_of_patterns(std::string_view start) {
    const std::string_view line = start.substr(0, start.find('\n'));
    return line.find_first_not_of("0123456789-+") == std::string_view::npos &&
           line.find('-') != std::string_view::npos;
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
