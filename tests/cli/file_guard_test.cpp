// SPDX-License-Identifier: GPL-3.0-or-later
// The files that verbs declare, and those that are refused before a verb runs.
#include "cli/command.hpp"
#include "program.hpp"
#include "support.hpp"

#include <fretwork/base/error.hpp>

#include <algorithm>
#include <map>
#include <set>

namespace fretwork::app {
namespace THIS_TEST {

namespace fs = std::filesystem;
using test::complaint_of;
using test::run_command;
using test::TemporaryFolder;
using testing::HasSubstr;

/// Options whose value is a text and no file. One that is in neither list is a mistake: declare it with
/// `declare_files` if it names a file.
const std::set<std::string> kOtherTexts = {
    "--edges",  "--min-angle",   "--max-valence", "--filter",   "--tile-side",  "--beam-width", "--require",
    "--forbid", "--edge-length", "--shard",       "--model",    "--optimizer",  "--tiles",      "--box",
    "--circle", "--polygon",     "--property",    "--range",    "--clearance",  "--strength",   "--deck-for",
    "name",     "new_name",      "--name",        "--problems", "--optimizers", "--policy",     "--solver",
    "--branch", "--masses",      "pattern",       "--address",  "--part",       "--narrow",     "--scale",
    "--angle",  "--command"};

/// The --patterns of these verbs may be a file.
bool takes_painting(const CLI::App& verb) {
    return verb.get_name() == "tile" || verb.get_name() == "retile" || verb.get_name() == "paint";
}

/// --patterns lists ids elsewhere.
bool is_other_text(const CLI::App& verb, const CLI::Option& option) {
    return kOtherTexts.contains(option.get_name()) ||
           (option.get_name() == "--patterns" && !takes_painting(verb)) ||
           (verb.get_name() == "known" && option.get_name() == "--patterns") ||
           (verb.get_name() == "export" && option.get_name() == "--case");
}

/// A verb with the words that choose it, and the verbs that it stands under: their options are its own, too.
struct Command {
    std::vector<std::string> words;
    std::vector<const CLI::App*> apps;

    [[nodiscard]] std::vector<const CLI::Option*> options() const {
        std::vector<const CLI::Option*> all;
        for (const CLI::App* app : apps) {
            for (const CLI::Option* option : app->get_options()) all.push_back(option);
        }
        return all;
    }
};

void add_commands(const CLI::App& app, const Command& above, std::vector<Command>& commands) {
    Command command = above;
    command.words.push_back(app.get_name());
    command.apps.push_back(&app);
    const auto below = app.get_subcommands([](const CLI::App*) { return true; });
    if (below.empty()) commands.push_back(command);
    for (const CLI::App* verb : below) add_commands(*verb, command, commands);
}

std::vector<Command> commands_of(const Program& program) {
    std::vector<Command> commands;
    for (const CLI::App* verb : program.get_subcommands([](const CLI::App*) { return true; }))
        add_commands(*verb, {}, commands);
    return commands;
}

const FileOption* declared(const Program& program, const CLI::Option* option) {
    const auto& files = program.file_options();
    const auto found = std::ranges::find(files, option, &FileOption::option);
    return found == files.end() ? nullptr : &*found;
}

/// The declared options of a command that have one of these roles.
std::vector<const FileOption*> files_of(const Program& program, const Command& command,
                                        const std::set<FileRole>& roles) {
    std::vector<const FileOption*> files;
    for (const CLI::Option* option : command.options()) {
        const FileOption* file = declared(program, option);
        if (file != nullptr && roles.contains(file->role)) files.push_back(file);
    }
    return files;
}

using Values = std::map<const CLI::Option*, std::string>;

/// A file of its kind that is not there.
std::string new_file(const FileOption& file, const fs::path& folder) {
    const std::string ending(file.kind.endings.substr(0, file.kind.endings.find(' ')));
    const std::string name = "new-" + std::to_string(reinterpret_cast<std::uintptr_t>(file.option));
    return (folder / (file.role == FileRole::OutputFolder ? name : name + ending)).string();
}

/// The command line with these values, and others for whatever the command cannot do without.
std::vector<std::string> line_of(const Program& program, const Command& command, const Values& values,
                                 const fs::path& folder) {
    std::vector<std::string> line = command.words;
    for (const CLI::Option* option : command.options()) {
        const FileOption* file = declared(program, option);
        const auto given = values.find(option);
        if (given == values.end() && !option->get_required()) continue;
        const std::string value = given != values.end() ? given->second
                                  : file                ? new_file(*file, folder)
                                                        : "1";
        if (!option->get_positional()) line.push_back(option->get_name());
        line.push_back(value);
    }
    return line;
}

/// The complaint about a command line; the verb itself does not run if the guard refuses it.
std::string complaint_about(std::vector<std::string> line) {
    std::ranges::reverse(line);
    ExitCode exit_code = ExitCode::Done;
    Program program(exit_code);
    return complaint_of([&] { program.parse(line); });
}

/// Other spellings of one file.
std::vector<std::string> spellings(const fs::path& file) {
    const fs::path folder = file.parent_path();
    const std::string ending = file.extension().string();
    fs::create_symlink(file, folder / ("symbolic" + ending));
    fs::create_hard_link(file, folder / ("hard" + ending));
    fs::create_directory_symlink(folder, folder / "circle");
    return {file.string(), (folder / "." / "circle" / file.filename()).string(), fs::relative(file).string(),
            (folder / ("symbolic" + ending)).string(), (folder / ("hard" + ending)).string()};
}

/// A name that fits the output, with its folder if it is one.
fs::path file_made_by(const FileOption& output, const fs::path& folder) {
    const std::string ending(output.kind.endings.substr(0, output.kind.endings.find(' ')));
    const std::string name = ending.starts_with('.') || ending.empty() ? "file" + ending : ending;
    return folder / name;
}

TEST(FileOptions, OfEveryVerbAreDeclared) {
    ExitCode exit_code = ExitCode::Done;
    const Program program(exit_code);
    for (const Command& command : commands_of(program)) {
        for (const CLI::Option* option : command.options()) {
            if (option->get_type_size() == 0) continue;  // a flag
            const bool is_text = option->get_type_name().starts_with("TEXT") || declared(program, option);
            if (!is_text || is_other_text(*command.apps.front(), *option) ||
                is_other_text(*command.apps.back(), *option))
                continue;
            EXPECT_TRUE(declared(program, option))
                << command.words.back() << " " << option->get_name() << " is declared by nobody";
        }
    }
}

TEST(FileGuard, RefusesEveryOutputThatIsAnInput) {
    ExitCode exit_code = ExitCode::Done;
    const Program program(exit_code);
    int pairs = 0;
    for (const Command& command : commands_of(program)) {
        for (const FileOption* output :
             files_of(program, command, {FileRole::Output, FileRole::OutputFolder})) {
            for (const FileOption* read : files_of(program, command, {FileRole::Input, FileRole::Update})) {
                const TemporaryFolder folder;
                const fs::path file = file_made_by(*output, folder.path());
                (void)folder.file(file.filename().string(), "content");
                for (const std::string& spelling : spellings(file)) {
                    const std::string written = output->role == FileRole::OutputFolder
                                                    ? fs::path(spelling).parent_path().string()
                                                    : spelling;
                    const auto line =
                        line_of(program, command, {{output->option, written}, {read->option, file.string()}},
                                folder.path());
                    EXPECT_THAT(complaint_about(line), HasSubstr("is read by this command"))
                        << testing::PrintToString(line);
                    ++pairs;
                }
                EXPECT_EQ(base::read_text_file(file), "content");
            }
        }
    }
    EXPECT_GE(pairs, 100) << "the verbs have more outputs and inputs than that";
}

// No command but those of libraries may put something in a library's place.
TEST(FileGuard, RefusesEveryOutputThatIsALibrary) {
    ExitCode exit_code = ExitCode::Done;
    const Program program(exit_code);
    for (const Command& command : commands_of(program)) {
        for (const FileOption* output :
             files_of(program, command, {FileRole::Output, FileRole::OutputFolder})) {
            if (output->kind.name == kLibraryFile.name) continue;
            const TemporaryFolder folder;
            const fs::path file = file_made_by(*output, folder.path());
            const std::string content("SQLite format 3\0and so on", 25);
            (void)folder.file(file.filename().string(), content);
            const fs::path written = output->role == FileRole::OutputFolder ? folder.path() : file;
            const auto line = line_of(program, command, {{output->option, written.string()}}, folder.path());
            EXPECT_THAT(complaint_about(line), HasSubstr("is a pattern library or another database"))
                << testing::PrintToString(line);
            EXPECT_EQ(base::read_text_file(file), content);
        }
    }
}

TEST(FileGuard, RefusesTwoOutputsInOneFile) {
    ExitCode exit_code = ExitCode::Done;
    const Program program(exit_code);
    for (const Command& command : commands_of(program)) {
        const auto outputs = files_of(program, command, {FileRole::Output});
        for (const FileOption* first : outputs) {
            for (const FileOption* second : outputs) {
                if (first == second) continue;
                const TemporaryFolder folder;
                fs::create_directory_symlink(folder.path(), folder.path() / "circle");
                const std::string name = new_file(*first, "");
                const auto line = line_of(program, command,
                                          {{first->option, (folder.path() / name).string()},
                                           {second->option, (folder.path() / "circle" / name).string()}},
                                          folder.path());
                EXPECT_THAT(complaint_about(line), HasSubstr("is named for two outputs"))
                    << testing::PrintToString(line);
            }
        }
    }
}

TEST(FileGuard, RefusesEndingsOfOtherKindsAndEmptyNames) {
    ExitCode exit_code = ExitCode::Done;
    const Program program(exit_code);
    for (const Command& command : commands_of(program)) {
        for (const FileOption* output : files_of(program, command, {FileRole::Output, FileRole::Update})) {
            const TemporaryFolder folder;
            const auto with = [&](const std::string& value) {
                return line_of(program, command, {{output->option, value}}, folder.path());
            };
            EXPECT_THAT(complaint_about(with("")), HasSubstr("is empty"));
            EXPECT_THAT(complaint_about(with((folder.path() / "nowhere" / "x.csv").string())),
                        HasSubstr("there is no folder"));
            EXPECT_THAT(complaint_about(with(folder.path().string())), HasSubstr("is a folder"));
            if (output->kind.endings.empty()) continue;
            EXPECT_THAT(complaint_about(with((folder.path() / "x.other").string())),
                        HasSubstr("whose name ends in "));
        }
    }
}

TEST(FileGuard, TakesEndingsInCapitals) {
    const TemporaryFolder folder;
    ExitCode exit_code = ExitCode::Done;
    Program program(exit_code);
    EXPECT_NO_THROW(program.parse({(folder.path() / "PATTERN.SVG").string(), "--out", "0-1+1-6", "draw"}));
}

TEST(FileGuard, RefusesToReplaceAFileOfAnotherKind) {
    const TemporaryFolder folder;
    (void)folder.file("p.json", R"({"load_cases": [], "format" : "fretwork/project/1"})");
    const auto path = [&](const char* name) { return (folder.path() / name).string(); };
    EXPECT_THAT(complaint_about({"solve", "frame.json", "--out", path("p.json")}),
                HasSubstr("p.json: is a project, and would be replaced by a result"));
    EXPECT_THAT(complaint_about({"enumerate", "--library", path("p.json")}),
                HasSubstr("p.json: is a project, where a pattern library is needed"));
}

class DataLoss : public testing::Test {
  protected:
    DataLoss() {
        run("fretwork enumerate --edges 2 --library L.db");
        run("cp experiments/outlines/specimen.svg outline.svg; cp experiments/layouts/paper7.json x.json");
        content_ = base::read_text_file(folder_.path() / "L.db");
    }
    test::Outcome run(const std::string& command) { return run_command(command, folder_.path()); }
    void expect_refused(const std::string& command) {
        const auto outcome = run(command);
        EXPECT_EQ(outcome.exit_code, 2) << command;
        EXPECT_EQ(base::read_text_file(folder_.path() / "L.db"), content_) << command;
    }
    TemporaryFolder folder_;
    std::string content_;
};

TEST_F(DataLoss, IsRefused) {
    ASSERT_THAT(content_, testing::StartsWith("SQLite format 3"));
    expect_refused("fretwork tile outline.svg --library L.db --edge-length 60mm --out L.db");
    expect_refused("fretwork tile outline.svg --library L.db --out outline.svg");
    expect_refused("fretwork tile outline.svg --layout x.json --out x.json");
    expect_refused("fretwork library export --library L.db --svg L.db");
    expect_refused("fretwork library export --library L.db --chart L.db");
    expect_refused("fretwork enumerate --edges 3 --svg L.db");
    expect_refused("fretwork enumerate --edges 3 --svg L.svg --layout ./L.svg");
    EXPECT_EQ(
        run("cmp outline.svg experiments/outlines/specimen.svg && cmp x.json experiments/layouts/paper7.json")
            .exit_code,
        0);
}

TEST_F(DataLoss, WhatAPersonHasMadeIsNeverReplaced) {
    run("fretwork tile outline.svg --edge-length 60mm --out p.json");
    for (const char* name : {"a.svg", "a.obj", "a.ply", "a.csv", "a.vtu"})
        (void)folder_.file(name, "drawn by hand\n");
    (void)folder_.file("notes.txt", "0 things to do\n");
    (void)folder_.file("foreign.json", "{\"rows\": [1]}");
    (void)folder_.file("pattern.csv", "mine,too\n");
    (void)folder_.file("frame.json", "{}");
    for (const std::string command :
         {"fretwork export p.json --to a.svg", "fretwork export p.json --to a.obj",
          "fretwork export p.json --to a.ply", "fretwork export p.json --to a.csv",
          "fretwork export p.json --to a.vtu", "fretwork enumerate --edges 2 --svg a.svg",
          "fretwork enumerate --edges 2 --census a.csv", "fretwork enumerate --edges 2 --list notes.txt",
          "fretwork solve frame.json --out foreign.json", "fretwork library export --library L.db --csv ."}) {
        const auto outcome = run(command);
        EXPECT_EQ(outcome.exit_code, 2) << command;
        EXPECT_THAT(outcome.err, HasSubstr("is not a file that fretwork has made, and would be replaced"))
            << command;
    }
    EXPECT_EQ(run("grep -l 'drawn by hand' a.* | wc -l").out, "5\n");
}

// Tables of hours of work, decks, frames: each is of another kind than what would be written.
TEST_F(DataLoss, OutputsOfAnotherKindAreNeverReplaced) {
    run("fretwork tile outline.svg --edge-length 60mm --patterns 0-1+1-6 --setting paper "
        "--out p.json && "
        "fretwork simulate p.json --case experiments/cases/cantilever.json --model full --out r.json "
        "--frame-out made.json --deck made.inp && ln -s made.inp link.svg && mkdir study");
    (void)folder_.file("known.csv", "problem,best_value,scale,found_by\nbranin,0.4,1,closed form\n");
    (void)folder_.file("study/results.csv", "problem,optimizer,repetition\nbranin,slsqp,1\n");
    run("fretwork draw 0-1+1-6 --out kept.svg && chmod 444 kept.svg");
    (void)folder_.file("frame.json", base::read_text_file(folder_.path() / "made.json") + "\n");
    for (const auto& [command, complaint] : std::vector<std::pair<std::string, std::string>>{
             {"fretwork beams p.json r.json --out known.csv", "known.csv: is a table of another kind"},
             {"fretwork export p.json --result r.json --to study/results.csv",
              "results.csv: is a table of another kind"},
             {"fretwork enumerate --edges 2 --census known.csv", "known.csv: is a table of another kind"},
             {"fretwork draw 0-1+1-6 --out link.svg",
              "link.svg: is a link to made.inp, whose name has another ending"},
             {"fretwork draw 0-1+1-6 --out kept.svg", "kept.svg: is protected: nobody may write it"},
             {"fretwork simulate p.json --case experiments/cases/cantilever.json --model full --out r.json "
              "--frame-out frame.json",
              "frame.json: is not a file that fretwork has made"}}) {
        const auto outcome = run(command);
        EXPECT_EQ(outcome.exit_code, 2) << command;
        EXPECT_THAT(outcome.err, HasSubstr(complaint)) << command;
    }
    EXPECT_THAT(base::read_text_file(folder_.path() / "made.inp"), testing::StartsWith("*HEADING"));
}

TEST_F(DataLoss, OldOutputsAndEmptyFilesAreReplacedAsPeopleExpect) {
    run("fretwork tile outline.svg --edge-length 60mm --patterns 0-1+1-6 --out p.json");
    run("touch s.svg c.csv e.obj");
    const std::string outputs =
        "fretwork enumerate --edges 2 --svg s.svg --census c.csv --classes k.csv --list i.txt && "
        "fretwork export p.json --to e.svg --to e.obj --to e.ply --to e.csv --to e.vtu && "
        "fretwork simulate p.json --case experiments/cases/cantilever.json --model full --out r.json "
        "--frame-out f.json --vtu r.vtu --svg r.svg && "
        "fretwork solve f.json --solver linear --out l.json --deck d.inp --vtu l.vtu";
    for (int time = 0; time < 2; ++time) {
        const auto outcome = run(outputs);
        EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    }
    const std::string tile = "fretwork tile outline.svg --edge-length 60mm --out p.json";
    EXPECT_EQ(run(tile + " && " + tile).exit_code, 0);
    const std::string library_export = "fretwork library export --library L.db --csv all --meshes all";
    EXPECT_EQ(run(library_export + " && " + library_export).exit_code, 0);
}

}  // namespace THIS_TEST
}  // namespace fretwork::app
