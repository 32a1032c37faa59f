// SPDX-License-Identifier: GPL-3.0-or-later
// fretwork optimizers: the methods there are, and how they compare.
#include "interrupt.hpp"
#include "options/checks.hpp"
#include "options/file_options.hpp"
#include "output.hpp"
#include "verbs.hpp"

#include <fretwork/base/error.hpp>
#include <fretwork/base/files/file.hpp>
#include <fretwork/base/internal/json_text.hpp>
#include <fretwork/base/named.hpp>
#include <fretwork/base/quantity.hpp>
#include <fretwork/base/stopwatch.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/optimization/methods/outside_command.hpp>
#include <fretwork/optimization/studies/known_value.hpp>
#include <fretwork/optimization/studies/landscape.hpp>
#include <fretwork/optimization/studies/study.hpp>
#include <fretwork/reduction/calibration/study_problems.hpp>
#include <fretwork/reduction/scenarios/setting_file.hpp>

#include <cstdio>
#include <memory>

namespace fretwork::app {
namespace {

using base::Json;
using optimization::study::Contender;

constexpr const char* kOptimizersExamples = R"(
Examples:
  fretwork optimizers list
  fretwork optimizers known --out known.csv
  fretwork optimizers run --known known.csv --problems calibration:4,analytic --repetitions 2 --out DIR)";

struct OptimizersOptions {
    std::string out;
    std::string ids;
    std::string known;
    std::string results;
    std::string problems = "all";
    std::string optimizers;             ///< empty: the commands, or all if there are none
    std::vector<std::string> commands;  ///< NAME=COMMAND
    std::string setting;                ///< a name or a file
    std::size_t patterns = 60;
    optimization::study::KnownValueOptions known_values;
    optimization::study::StudyPlan plan;
    optimization::study::LandscapeOptions landscape;
    int threads = 0;
    bool json = false;
};

/// The name of --setting in ids of problems: a file's name without its ending, else the text itself.
std::string setting_name(const OptimizersOptions& options) {
    return std::filesystem::path(options.setting).stem().string();
}

std::vector<reduction::NamedSetting> given_settings(const OptimizersOptions& options) {
    if (options.setting.empty()) return {};
    return {{setting_name(options), reduction::find_setting(options.setting)}};
}

optimization::study::ProblemFamilies families_of(const OptimizersOptions& options) {
    return base::located("--setting", "", [&] { return reduction::study_families(given_settings(options)); });
}

/// The problems of a comparison in the setting of --setting, or else in the paper's.
std::vector<std::string> problems_to_choose(const OptimizersOptions& options) {
    return options.setting.empty() ? reduction::study_problem_ids(options.patterns)
                                   : reduction::study_problem_ids_in(setting_name(options), options.patterns);
}

// ---- list ----

ExitCode list(const OptimizersOptions& options) {
    Json rows = Json::array();
    for (const Contender& contender : optimization::study::default_contenders()) {
        const auto& row = *contender.method;
        if (options.json) {
            rows.push_back({{"name", row.name},
                            {"class", optimizer_class_name(row.kind)},
                            {"needs", evaluation_name(row.needs)},
                            {"starts_in_comparison", contender.starts},
                            {"summary", row.summary}});
        } else {
            std::printf("%-24s %-7s %-10s %s\n", std::string(row.name).c_str(),
                        std::string(optimizer_class_name(row.kind)).c_str(),
                        std::string(evaluation_name(row.needs)).c_str(), std::string(row.summary).c_str());
        }
    }
    if (options.json) print_document({{"optimizers", rows}});
    return ExitCode::Done;
}

// ---- known ----

ExitCode known(OptimizersOptions options) {
    LongWork work;
    options.known_values.threads = options.threads;
    options.known_values.control = work.control();
    options.known_values.families = families_of(options);
    const auto search = [&] {
        const auto ids = options.ids.empty() ? problems_to_choose(options)
                                             : optimization::study::read_problem_ids(
                                                   options.ids, options.known_values.families);
        return find_known_values(ids, options.known_values);
    };
    auto values = options.known.empty() ? search() : optimization::study::read_known_values(options.known);
    if (!options.results.empty()) improve_known_values(values, options.results);
    base::write_file_atomically(options.out, known_values_csv(values));
    if (options.json) {
        print_document({{"problems", values.size()}, {"out", options.out}});
    } else {
        std::printf("%zu problems with their best known values are in %s\n", values.size(),
                    options.out.c_str());
    }
    return ExitCode::Done;
}

// ---- run ----

/// The methods that are programs of their own, from NAME=COMMAND.
std::vector<optimization::OptimizerRow> rows_of_commands(const std::vector<std::string>& commands) {
    std::vector<optimization::OptimizerRow> rows;
    for (const std::string& given : commands) {
        const auto middle = given.find('=');
        if (middle == std::string::npos)
            throw base::InputError("--command", "", "'" + given + "' is not NAME=COMMAND");
        const optimization::OutsideCommand method{given.substr(0, middle), given.substr(middle + 1)};
        rows.push_back(base::located("--command", "", [&] { return outside_command_row(method); }));
        const auto has_name = [&](const auto& row) { return row.name == method.name; };
        if (std::ranges::any_of(optimization::optimizer_catalogue(), has_name) ||
            std::ranges::count_if(rows, has_name) > 1)
            throw base::InputError("--command", "", "there is a method '" + method.name + "' already");
    }
    return rows;
}

/// "slsqp" with the comparison's number of starts, "slsqp:32" with 32.
Contender chosen_contender(const std::string& word, const std::vector<Contender>& all) {
    const auto colon = word.find(':');
    const std::string name = word.substr(0, colon);
    const auto name_of = [](const Contender& one) { return one.method->name; };
    Contender contender = base::find_named(name, all, name_of, "optimizer");
    if (colon == std::string::npos) return contender;
    const auto starts = base::read_number<int>(word.substr(colon + 1));
    if (!starts)
        throw base::InputError("--optimizers: '" + word + "' has no number of starts after its colon");
    optimization::OptimizerOptions{.starts = *starts}.validate();
    contender.starts = *starts;
    return contender;
}

/// The methods of --optimizers; without this option those of --command, or all if there are none.
std::vector<Contender> chosen_contenders(const std::string& choice,
                                         const std::vector<optimization::OptimizerRow>& commands) {
    std::vector<Contender> own;
    for (const optimization::OptimizerRow& row : commands) own.push_back({&row, 1});
    if (choice.empty() && !own.empty()) return own;
    std::vector<Contender> all = optimization::study::default_contenders();
    all.insert(all.end(), own.begin(), own.end());
    if (choice.empty() || choice == "all") return all;
    std::vector<Contender> chosen;
    for (const std::string& word : base::split(choice, ',')) chosen.push_back(chosen_contender(word, all));
    return chosen;
}

/// The problems that --problems chooses from the file of known values.
std::vector<std::string> problems_of(const OptimizersOptions& options) {
    std::vector<std::string> ids;
    for (const optimization::study::KnownValue& value : optimization::study::read_known_values(options.known))
        ids.push_back(value.problem);
    return optimization::study::chosen_problems(ids, options.problems);
}

std::filesystem::path made_folder(const std::string& path) {
    std::error_code fault;
    std::filesystem::create_directories(path, fault);
    if (fault) throw base::IoError("--out: cannot make the folder '" + path + "': " + fault.message());
    return path;
}

void print(const optimization::study::StudyReport& report, double seconds, const OptimizersOptions& options) {
    const std::string path = optimization::study::run_table_path(options.out).string();
    if (options.json) {
        print_document({{"runs_before", report.runs_before},
                        {"runs_done", report.runs_done},
                        {"runs_stopped", report.runs_stopped},
                        {"out", path},
                        {"seconds", seconds}});
    } else {
        std::printf("%zu runs in %.1f s, and %zu that were there before, are in %s\n", report.runs_done,
                    seconds, report.runs_before, path.c_str());
    }
    if (report.runs_stopped > 0)
        warn(base::counted(report.runs_stopped, "run") +
             " stopped: the program did not come to its end, for example because it went on after the answer "
             "'spent'");
    if (report.runs_left_out > 0) warn("interrupted; what is done is stored, run again to go on");
}

ExitCode run(OptimizersOptions options) {
    LongWork work;
    options.plan.problems = problems_of(options);
    options.plan.families = families_of(options);
    const auto commands = rows_of_commands(options.commands);
    options.plan.contenders = chosen_contenders(options.optimizers, commands);
    options.plan.threads = options.threads;
    options.plan.control = work.control();
    options.plan.validate();
    const base::Stopwatch watch;
    const optimization::study::StudyReport report = run_study(options.plan, made_folder(options.out));
    print(report, watch.seconds(), options);
    return report.runs_left_out > 0 ? ExitCode::DidNotSucceed : ExitCode::Done;
}

// ---- landscape ----

ExitCode landscape(OptimizersOptions options) {
    LongWork work;
    options.landscape.threads = options.threads;
    options.landscape.control = work.control();
    options.landscape.families = families_of(options);
    const auto problems = problems_of(options);
    const optimization::study::Landscape landscape = explore_landscape(problems, options.landscape);
    const auto folder = made_folder(options.out);
    base::FileBatch files;
    files.add(folder / "descents.csv", landscape.descents);
    files.add(folder / "sections.csv", landscape.sections);
    files.commit();
    if (options.json) {
        print_document({{"problems", problems.size()}, {"out", options.out}});
    } else {
        std::printf("descents.csv and sections.csv of %zu problems are in %s\n", problems.size(),
                    options.out.c_str());
    }
    return ExitCode::Done;
}

// ---- the command line ----

void add_setting(CLI::App& action, OptimizersOptions& options) {
    action.add_option("--setting", options.setting,
                      "Setting of the calibration problems: paper, made, or a file NAME.json. The ids of the "
                      "problems then end in @NAME (default: paper, with ids without @NAME)");
}

CLI::Option* add_threads(CLI::App& action, OptimizersOptions& options) {
    return action.add_option("--threads", options.threads, "Threads to use; 0: one for each processor")
        ->check(thread_check());
}

void add_list(CLI::App& verb, const std::shared_ptr<OptimizersOptions>& options, ExitCode& exit_code) {
    CLI::App* action =
        verb.add_subcommand("list", "List the optimizers: name, class, needed evaluations, summary");
    action->add_flag("--json", options->json, "Print JSON");
    action->footer("Example: fretwork optimizers list");
    action->callback([options, &exit_code] { exit_code = list(*options); });
}

void add_known(CLI::App& verb, const std::shared_ptr<OptimizersOptions>& options, ExitCode& exit_code) {
    CLI::App* action = verb.add_subcommand("known",
                                           "Choose the problems of a comparison, and search for the best "
                                           "value of each. Do this once, before `run`");
    action->add_option("--out", options->out, "The CSV file to write")->required();
    action
        ->add_option("--patterns", options->patterns,
                     "Number of calibration problems. Each is one pattern; the patterns are spread over "
                     "numbers of edges and over stiffness")
        ->check(CLI::Range(1, 1'000'000))
        ->capture_default_str();
    action
        ->add_option("--starts", options->known_values.starts,
                     "Number of descents of each multistart method on each problem")
        ->capture_default_str();
    action
        ->add_option(
            "--ids", options->ids,
            "File with the problems to take, one id on each line, instead of choosing them by --patterns")
        ->excludes("--patterns");
    action
        ->add_option("--from", options->known,
                     "Take the known values of this file instead of searching for them")
        ->excludes("--patterns")
        ->excludes("--ids")
        ->excludes("--starts");
    action->add_option("--results", options->results,
                       "Table of runs (results.csv): where a run found a lower value, take it");
    add_setting(*action, *options);
    add_threads(*action, *options)->excludes("--from");
    action->add_flag("--json", options->json, "Print JSON");
    declare_files(*action, {output("--out", kKnownFile), input("--ids"), input("--from"), input("--results"),
                            input("--setting")});
    action->footer("Example: fretwork optimizers known --patterns 12 --starts 10 --out known.csv");
    action->callback([options, &exit_code] { exit_code = known(*options); });
}

void add_run(CLI::App& verb, const std::shared_ptr<OptimizersOptions>& options, ExitCode& exit_code) {
    CLI::App* action =
        verb.add_subcommand("run",
                            "Run optimizers on problems. A stopped comparison continues at the next run. "
                            "experiments/optimizer_comparison/method.md explains the columns");
    action->add_option("--known", options->known, "The problems, as `known` wrote them")->required();
    action->add_option("--out", options->out, "Folder for results.csv")->required();
    action
        ->add_option("--problems", options->problems,
                     "all, or problem ids, families (such as calibration or analytic) and family:N (N "
                     "problems of a family), joined by commas")
        ->capture_default_str();
    action->add_option("--optimizers", options->optimizers,
                       "all, or names joined by commas; slsqp:32 is slsqp with 32 starts (default: all, or "
                       "with --command only its programs)");
    action
        ->add_option("--command", options->commands,
                     "Optimizer that is another program (repeatable). It reads the bounds, asks for values, "
                     "and ends with done; see docs/guide/own_optimizer.md")
        ->type_name("NAME=COMMAND");
    action
        ->add_option(
            "--repetitions", options->plan.repetitions,
            "Number of runs of each optimizer; an optimizer of the class global uses no seed and runs once")
        ->capture_default_str();
    action
        ->add_option("--budget", options->plan.conditions.budget.cost,
                     "Largest cost of one run; for calibrations, the unit is one factorization of the "
                     "reduced model's stiffness")
        ->capture_default_str();
    action
        ->add_option("--seed", options->plan.conditions.seed,
                     "Seed; the seeds of all runs are derived from it")
        ->check(seed_check())
        ->capture_default_str();
    add_setting(*action, *options);
    add_threads(*action, *options);
    action->add_flag("--json", options->json, "Print JSON");
    declare_files(*action, {input("--known"), input("--setting"), output_folder("--out", "results.csv")});
    action->footer(
        "Examples: fretwork optimizers run --known known.csv --optimizers slsqp:32,cma-es --repetitions 3 "
        "--out DIR\n"
        "          fretwork optimizers run --known known.csv --command 'mine=python3 mine.py' --out DIR");
    action->callback([options, &exit_code] { exit_code = run(*options); });
}

void add_landscape(CLI::App& verb, const std::shared_ptr<OptimizersOptions>& options, ExitCode& exit_code) {
    CLI::App* action = verb.add_subcommand("landscape",
                                           "Write two tables: where many single descents end, and the "
                                           "objective along each variable through the best point");
    action->add_option("--known", options->known, "The problems, as `known` wrote them")->required();
    action->add_option("--out", options->out, "Folder for descents.csv and sections.csv")->required();
    action
        ->add_option("--problems", options->problems,
                     "all, or problem ids, families (such as calibration or analytic) and family:N (N "
                     "problems of a family), joined by commas")
        ->capture_default_str();
    action
        ->add_option("--descents", options->landscape.descents,
                     "Number of descents of each kind on each problem")
        ->capture_default_str();
    add_setting(*action, *options);
    add_threads(*action, *options);
    action->add_flag("--json", options->json, "Print JSON");
    declare_files(
        *action, {input("--known"), input("--setting"), output_folder("--out", "descents.csv sections.csv")});
    action->footer(
        "Example: fretwork optimizers landscape --known known.csv --problems calibration:2 --descents 50 "
        "--out DIR");
    action->callback([options, &exit_code] { exit_code = landscape(*options); });
}

}  // namespace

void add_optimizers(CLI::App& app, ExitCode& exit_code) {
    CLI::App* verb =
        app.add_subcommand("optimizers", "List the optimizers, and compare them on a set of problems");
    const auto options = std::make_shared<OptimizersOptions>();
    add_list(*verb, options, exit_code);
    add_known(*verb, options, exit_code);
    add_run(*verb, options, exit_code);
    add_landscape(*verb, options, exit_code);
    verb->require_subcommand(1);
    verb->footer(kOptimizersExamples);
}

}  // namespace fretwork::app
