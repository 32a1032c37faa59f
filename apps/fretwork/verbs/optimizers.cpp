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
#include <fretwork/base/quantity.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/optimization/studies/known_value.hpp>
#include <fretwork/optimization/studies/landscape.hpp>
#include <fretwork/optimization/studies/study.hpp>
#include <fretwork/reduction/calibration/study_problems.hpp>

#include <chrono>
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
    std::string optimizers = "all";
    std::size_t patterns = 60;
    optimization::study::KnownValueOptions known_values;
    optimization::study::StudyPlan plan;
    optimization::study::LandscapeOptions landscape;
    int threads = 0;
    bool json = false;
};

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
    options.known_values.families = reduction::study_families();
    const auto search = [&] {
        const auto ids = options.ids.empty() ? reduction::study_problem_ids(options.patterns)
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

/// "slsqp" with the comparison's number of starts, "slsqp:32" with 32.
Contender chosen_contender(const std::string& word) {
    const auto colon = word.find(':');
    const auto all = optimization::study::default_contenders();
    const auto* row = &optimization::find_optimizer(word.substr(0, colon));
    Contender contender = *std::ranges::find(all, row, &Contender::method);
    if (colon == std::string::npos) return contender;
    const auto starts = base::read_number<int>(word.substr(colon + 1));
    if (!starts)
        throw base::InputError("--optimizers: '" + word + "' has no number of starts after its colon");
    optimization::OptimizerOptions{.starts = *starts}.validate();
    contender.starts = *starts;
    return contender;
}

std::vector<Contender> chosen_contenders(const std::string& choice) {
    if (choice == "all") return optimization::study::default_contenders();
    std::vector<Contender> chosen;
    for (const std::string& word : base::split(choice, ',')) chosen.push_back(chosen_contender(word));
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
                        {"out", path},
                        {"seconds", seconds}});
    } else {
        std::printf("%zu runs in %.1f s, and %zu that were there before, are in %s\n", report.runs_done,
                    seconds, report.runs_before, path.c_str());
    }
    if (report.runs_left_out > 0) warn("interrupted; what is done is stored, run again to go on");
}

ExitCode run(OptimizersOptions options) {
    LongWork work;
    options.plan.problems = problems_of(options);
    options.plan.families = reduction::study_families();
    options.plan.contenders = chosen_contenders(options.optimizers);
    options.plan.threads = options.threads;
    options.plan.control = work.control();
    options.plan.validate();
    const auto begin = std::chrono::steady_clock::now();
    const optimization::study::StudyReport report = run_study(options.plan, made_folder(options.out));
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
    print(report, seconds.count(), options);
    return report.runs_left_out > 0 ? ExitCode::DidNotSucceed : ExitCode::Done;
}

// ---- landscape ----

ExitCode landscape(OptimizersOptions options) {
    LongWork work;
    options.landscape.threads = options.threads;
    options.landscape.control = work.control();
    options.landscape.families = reduction::study_families();
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

CLI::Option* add_threads(CLI::App& action, OptimizersOptions& options) {
    return action.add_option("--threads", options.threads, "Threads to use; 0: one for each processor")
        ->check(thread_check());
}

void add_list(CLI::App& verb, const std::shared_ptr<OptimizersOptions>& options, ExitCode& exit_code) {
    CLI::App* action =
        verb.add_subcommand("list", "List the methods: name, class, needed evaluations, summary");
    action->add_flag("--json", options->json, "Print JSON");
    action->footer("Example: fretwork optimizers list");
    action->callback([options, &exit_code] { exit_code = list(*options); });
}

void add_known(CLI::App& verb, const std::shared_ptr<OptimizersOptions>& options, ExitCode& exit_code) {
    CLI::App* action = verb.add_subcommand(
        "known", "Choose the problems of a comparison, and search for their best values once");
    action->add_option("--out", options->out, "The CSV file to write")->required();
    action
        ->add_option("--patterns", options->patterns, "Calibration problems, spread over edges and stiffness")
        ->check(CLI::Range(1, 1'000'000))
        ->capture_default_str();
    action
        ->add_option("--starts", options->known_values.starts, "Descents of each calibrator on each problem")
        ->capture_default_str();
    action
        ->add_option("--ids", options->ids,
                     "Take these problems, one id on each line, instead of choosing some")
        ->excludes("--patterns");
    action->add_option("--from", options->known, "Begin with this file instead of searching")
        ->excludes("--patterns")
        ->excludes("--ids")
        ->excludes("--starts");
    action->add_option("--results", options->results, "Lower the values to those that these runs found");
    add_threads(*action, *options)->excludes("--from");
    action->add_flag("--json", options->json, "Print JSON");
    declare_files(*action,
                  {output("--out", kKnownFile), input("--ids"), input("--from"), input("--results")});
    action->footer("Example: fretwork optimizers known --patterns 12 --starts 10 --out known.csv");
    action->callback([options, &exit_code] { exit_code = known(*options); });
}

void add_run(CLI::App& verb, const std::shared_ptr<OptimizersOptions>& options, ExitCode& exit_code) {
    CLI::App* action = verb.add_subcommand("run",
                                           "Run methods on problems; a stopped comparison continues. "
                                           "Columns: see experiments/optimizer_comparison/method.md");
    action->add_option("--known", options->known, "The problems, as `known` wrote them")->required();
    action->add_option("--out", options->out, "Folder for results.csv")->required();
    action->add_option("--problems", options->problems, "all, or ids, families and family:N joined by commas")
        ->capture_default_str();
    action
        ->add_option("--optimizers", options->optimizers,
                     "all, or names joined by commas; slsqp:32 is slsqp with 32 starts")
        ->capture_default_str();
    action->add_option("--repetitions", options->plan.repetitions, "Runs of each method that uses the seed")
        ->capture_default_str();
    action
        ->add_option("--budget", options->plan.conditions.budget.cost,
                     "Of one run, in the problem's unit of cost")
        ->capture_default_str();
    action->add_option("--seed", options->plan.conditions.seed, "Changes the seeds of all runs")
        ->check(seed_check())
        ->capture_default_str();
    add_threads(*action, *options);
    action->add_flag("--json", options->json, "Print JSON");
    declare_files(*action, {input("--known"), output_folder("--out", "results.csv")});
    action->footer(
        "Example: fretwork optimizers run --known known.csv --optimizers slsqp:32,cma-es --repetitions 3 "
        "--out DIR");
    action->callback([options, &exit_code] { exit_code = run(*options); });
}

void add_landscape(CLI::App& verb, const std::shared_ptr<OptimizersOptions>& options, ExitCode& exit_code) {
    CLI::App* action = verb.add_subcommand(
        "landscape",
        "Write tables of the ends of many single descents, and of sections through the best point");
    action->add_option("--known", options->known, "The problems, as `known` wrote them")->required();
    action->add_option("--out", options->out, "Folder for descents.csv and sections.csv")->required();
    action->add_option("--problems", options->problems, "all, or ids, families and family:N joined by commas")
        ->capture_default_str();
    action->add_option("--descents", options->landscape.descents, "Of each kind on each problem")
        ->capture_default_str();
    add_threads(*action, *options);
    action->add_flag("--json", options->json, "Print JSON");
    declare_files(*action, {input("--known"), output_folder("--out", "descents.csv sections.csv")});
    action->footer(
        "Example: fretwork optimizers landscape --known known.csv --problems calibration:2 --descents 50 "
        "--out DIR");
    action->callback([options, &exit_code] { exit_code = landscape(*options); });
}

}  // namespace

void add_optimizers(CLI::App& app, ExitCode& exit_code) {
    CLI::App* verb = app.add_subcommand("optimizers", "List the optimizers, and compare them");
    const auto options = std::make_shared<OptimizersOptions>();
    add_list(*verb, options, exit_code);
    add_known(*verb, options, exit_code);
    add_run(*verb, options, exit_code);
    add_landscape(*verb, options, exit_code);
    verb->require_subcommand(1);
    verb->footer(kOptimizersExamples);
}

}  // namespace fretwork::app
