// SPDX-License-Identifier: GPL-3.0-or-later
// fretwork check: whether files are valid files of their kinds.
#include "options/file_options.hpp"
#include "output.hpp"
#include "tools/file_kinds.hpp"
#include "verbs.hpp"

#include <fretwork/base/error.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/pattern/node_layout.hpp>

#include <algorithm>
#include <cstdio>
#include <memory>

namespace fretwork::app {
namespace {

struct CheckOptions {
    std::vector<std::string> files;
    std::string layout;
    bool json = false;
};

struct CheckedFile {
    std::string file;
    std::string kind;   ///< empty if it is not valid
    std::string error;  ///< empty if it is valid
};

/// One bad file of many does not end the check of the rest.
CheckedFile checked(const std::string& file, const std::string& layout) {
    try {
        return {file, check_file(file, layout), ""};
    } catch (const base::Error& error) {
        return {file, "", error.what()};
    }
}

void print_line(const CheckedFile& file) {
    if (file.error.empty())
        std::printf("%s: valid %s\n", base::printable(file.file).c_str(), file.kind.c_str());
    else
        complain(file.error);
}

base::Json checked_json(const CheckedFile& file) {
    base::Json json = {{"file", file.file}, {"valid", file.error.empty()}};
    if (file.error.empty())
        json["kind"] = file.kind;
    else
        json["error"] = file.error;
    return json;
}

void check_layout(const std::string& layout) {
    base::located("--layout", "", [&] { (void)pattern::find_node_layout(layout); });
}

/// A layout that no file uses would be ignored. A file that is not valid may be a painting.
void require_painting(const std::vector<CheckedFile>& files) {
    const auto may_use_layout = [](const CheckedFile& file) {
        return !file.error.empty() || file.kind.starts_with("fretwork/painting/");
    };
    if (std::ranges::none_of(files, may_use_layout))
        throw base::InputError("--layout", "", "is for paintings, and none of the files is one");
}

ExitCode run(const CheckOptions& options) {
    if (!options.layout.empty()) check_layout(options.layout);
    std::vector<CheckedFile> files;
    for (const std::string& name : options.files) files.push_back(checked(name, options.layout));
    if (!options.layout.empty()) require_painting(files);
    if (!options.json) {
        for (const CheckedFile& file : files) print_line(file);
    } else {
        base::Json list = base::Json::array();
        for (const CheckedFile& file : files) list.push_back(checked_json(file));
        print_document({{"files", list}});
    }
    const bool is_valid =
        std::ranges::all_of(files, [](const CheckedFile& file) { return file.error.empty(); });
    return is_valid ? ExitCode::Done : ExitCode::BadInput;
}

}  // namespace

void add_check(CLI::App& app, ExitCode& exit_code) {
    CLI::App* verb = app.add_subcommand("check", "Check that files are valid files of their kinds");
    const auto options = std::make_shared<CheckOptions>();
    verb->add_option("file", options->files, "Files: JSON, library, outline, mesh, deck or image")
        ->required();
    verb->add_option("--layout", options->layout,
                     "Node layout of paintings: a name or a file (default: the built-in one that they name)");
    verb->add_flag("--json", options->json, "Print JSON");
    declare_files(*verb, {input("file"), input("--layout")});
    verb->footer(
        "Exit code 0: all are valid; 2: one is not.\nExample: fretwork check project.json outline.svg");
    verb->callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace fretwork::app
